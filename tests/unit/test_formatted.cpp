#include "base/formatted.h"
#include "test.h"

TEST_CASE("a text of any length is formatted whole") {
    CHECK(formatted("%d, %.2f, %s", 7, 0.125, "x") == "7, 0.12, x");
    for (const std::size_t n : {0u, 199u, 200u, 201u, 5000u}) {
        const std::string text(n, 'a');
        CHECK(formatted("%s", text.c_str()) == text);
    }
}
