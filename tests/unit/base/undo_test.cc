#include "base/undo.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <iostream>
#include <string>
#include <thread>

namespace geneva::base {
namespace {

// undo_all() leaves a process in which nothing goes on: each test has one of its own for it.

using testing::ExitedWithCode;

/// An action that says so.
std::function<void()> says(const std::string& word) {
  return [word] { std::cerr << word << ' '; };
}

void wait_a_little() { std::this_thread::sleep_for(std::chrono::milliseconds(50)); }

TEST(Undo, ActionsRunTheNewestFirst) {
  const auto end = [] {
    const Undo first(says("first"));
    const Undo second(says("second"));
    undo_all();
    _exit(0);
  };
  EXPECT_EXIT(end(), ExitedWithCode(0), "second first");
}

TEST(Undo, AnActionThatWasTakenBackDoesNotRun) {
  const auto end = [] {
    const Undo kept(says("kept"));
    { const Undo taken_back(says("taken back")); }
    undo_all();
    _exit(0);
  };
  EXPECT_EXIT(end(), ExitedWithCode(0), "^kept $");
}

TEST(Undo, WhatMustNotBeInterruptedComesToItsEnd) {
  const auto end = [] {
    std::atomic<bool> is_held(false);
    std::atomic<bool> is_done(false);
    std::thread other([&] {
      const auto held = not_to_be_interrupted();
      is_held = true;
      wait_a_little();
      is_done = true;
    });
    while (!is_held) std::this_thread::yield();
    undo_all();
    _exit(is_done ? 0 : 1);
  };
  EXPECT_EXIT(end(), ExitedWithCode(0), "");
}

TEST(Undo, NothingThatIsGuardedGoesOnAfterIt) {
  const auto end = [] {
    std::atomic<bool> went_on(false);
    undo_all();
    std::thread other([&] {
      const Undo late(says("late"));
      went_on = true;
    });
    wait_a_little();
    _exit(went_on ? 1 : 0);
  };
  EXPECT_EXIT(end(), ExitedWithCode(0), "");
}

}  // namespace
}  // namespace geneva::base
