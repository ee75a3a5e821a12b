#include "base/errors.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <type_traits>

#include "base/printable.h"

namespace geneva::base {
namespace {

/// Which handler an error meets: those of exit codes 1, 2 and 3 in their order.
template <typename Error>
int handler_of() {
  try {
    throw Error("text");
  } catch (const InputError&) {
    return 1;
  } catch (const LimitReached&) {
    return 2;
  } catch (const std::exception&) {
    return 3;
  }
}

TEST(Errors, KindsAreToldApart) {
  EXPECT_EQ(handler_of<InputError>(), 1);
  EXPECT_EQ(handler_of<LimitReached>(), 2);
  EXPECT_EQ(handler_of<std::invalid_argument>(), 3);  // a library's own is no mistake of the user
  EXPECT_EQ(handler_of<std::runtime_error>(), 3);
}

TEST(Errors, InputErrorsAreInvalidArgumentsAndLimitsAreNot) {
  EXPECT_TRUE((std::is_base_of_v<std::invalid_argument, InputError>));
  EXPECT_FALSE((std::is_base_of_v<std::invalid_argument, LimitReached>));
}

TEST(Printable, ControlCharactersBecomeSpaces) {
  EXPECT_EQ(printable("a\x1b[2Jb\nc\x7f"), "a [2Jb c ");
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J"),
            "  2J");
  EXPECT_EQ(printable("\xc3\xa9 \xc2\xb5m \xc2"), "\xc3\xa9 \xc2\xb5m \xc2");
}

TEST(Printable, LongTextsAreCut) {
  EXPECT_EQ(printable(std::string(1000, 'x')), std::string(1000, 'x'));
  EXPECT_EQ(printable(std::string(1001, 'x')), std::string(1000, 'x') + "...");
}

}  // namespace
}  // namespace geneva::base
