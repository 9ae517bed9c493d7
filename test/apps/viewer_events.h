// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests that send events to an X server.

#pragma once

#include <gtest/gtest.h>

#include "pictures.h"
#include "render/display.h"

#include <cstdlib>
#include <memory>

namespace app_test {

/** A display that events are sent to. */
class WithEvents : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (runInShell("command -v xdotool").exit_code != 0)
      GTEST_SKIP() << "no xdotool here, which sends events: install it";
    unsetenv("DISPLAY");
    display_ = std::make_unique<app::Display>();
    ASSERT_TRUE(display_->ready());
  }

  std::unique_ptr<app::Display> display_;
};

} // namespace app_test
