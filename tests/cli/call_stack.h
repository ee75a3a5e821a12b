#pragma once

#include <dlfcn.h>
#include <execinfo.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>

/// Whether one of the functions that are being run is as asked for.
template <typename Question>
bool is_any_call(const Question& question) {
  constexpr int depth = 64;
  void* calls[depth];
  const int found = ::backtrace(calls, depth);
  return std::any_of(calls, calls + found, [&](const void* const call) {
    Dl_info info;
    return ::dladdr(call, &info) != 0 && question(info);
  });
}

/// Whether one of them has all these words in its symbol.
inline bool is_within(const std::initializer_list<const char*> words) {
  return is_any_call([&](const Dl_info& info) {
    return info.dli_sname != nullptr &&
           std::all_of(words.begin(), words.end(), [&](const char* const word) {
             return std::strstr(info.dli_sname, word) != nullptr;
           });
  });
}

/// Whether a function of a library is being run.
/// @param name part of its file's name
inline bool is_within_library(const char* const name) {
  return is_any_call([&](const Dl_info& info) {
    return info.dli_fname != nullptr && std::strstr(info.dli_fname, name) != nullptr;
  });
}

/// Functions of libraries that no exception may leave: what they made by halves ends in a crash.
/// deal.II 9.4 loses exceptions of its tasks while it builds an element of several components, and
/// then reads what is not there. TBB waits for ever where an exception has left its own start,
/// which the program lets it do first of all.
inline bool is_where_nothing_may_fail() {
  return is_within({"FESystem", "initialize"}) || is_within_library("libtbb");
}
