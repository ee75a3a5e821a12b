#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "base/errors.h"

/// What throws an exception of each kind that the program may meet, by names that failures.py
/// knows.
inline const std::map<std::string, std::function<void()>>& failure_kinds() {
  static const std::map<std::string, std::function<void()>> kinds{
      {"input", [] { throw geneva::base::InputError("a wrong input"); }},
      {"limit", [] { throw geneva::base::LimitReached("a limit"); }},
      {"memory",
       [] {
         // As operator new does.
         if (const std::new_handler handler = std::get_new_handler()) handler();
         throw std::bad_alloc();
       }},
      {"system",
       [] {
         throw std::filesystem::filesystem_error("no such place",
                                                 std::make_error_code(std::errc::io_error));
       }},
      {"bug", [] { throw std::logic_error("a mistake"); }},
      {"no exception", [] { throw 42; }}};
  return kinds;
}
