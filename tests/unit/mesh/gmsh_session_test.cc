#include "mesher/gmsh_session.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/errors.h"

namespace geneva::mesher {
namespace {

using Errors = std::vector<std::string>;

/// Errors of an action of which nothing but what it throws goes wrong.
Errors errors_of(const std::function<void()>& action) {
  GmshSession session;
  return session.errors_of(action);
}

/// Asks for a list of so many entries.
void ask_for(const std::size_t entries) { std::vector<double>().reserve(entries); }

TEST(GmshSession, ListsOfImpossibleLengthAreCalledThat) {
  const Errors expected{
      "memory ran out ('Maximum memory'), or a list of impossible length is asked for"};
  EXPECT_EQ(errors_of([] { throw std::bad_alloc(); }), expected);
  EXPECT_EQ(errors_of([] { throw std::bad_array_new_length(); }), expected);
  EXPECT_EQ(errors_of([] { ask_for(std::numeric_limits<std::size_t>::max()); }), expected);
}

TEST(GmshSession, EveryExceptionIsAnErrorInWords) {
  EXPECT_EQ(errors_of([] { throw base::InputError("no cells"); }), Errors{"no cells"});
  EXPECT_EQ(errors_of([] { throw std::string("Gmsh's own"); }), Errors{"Gmsh's own"});
  EXPECT_EQ(errors_of([] { throw 1; }), Errors{"Gmsh met an error that it has no words for"});
  const Errors out_of_range = errors_of([] { (void)std::vector<int>().at(7); });
  ASSERT_EQ(out_of_range.size(), 1U);
  EXPECT_EQ(out_of_range[0].find("vector"), std::string::npos) << out_of_range[0];
}

TEST(GmshSession, WhatGoesWellHasNoErrors) {
  EXPECT_EQ(errors_of([] {}), Errors{});
}

}  // namespace
}  // namespace geneva::mesher
