#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "app/session.h"
#include "support/scratch_folder.h"

namespace limn::app {

/// A session that has opened the cube, driven by actions, with a folder to read and write in.
class SessionTest : public testing::Test {
 protected:
  SessionTest() { session_.perform({ui::ActionId::kOpenBundled, std::string("cube")}); }

  void stroke(std::vector<std::uint32_t> faces, DepthChange change = DepthChange::add(1)) {
    session_.begin_stroke(change);
    session_.touch(faces);
    session_.end_stroke();
  }

  [[nodiscard]] std::vector<int> depths() const {
    const auto values = session_.document().depths.values();
    return {values.begin(), values.end()};
  }

  template <class T>
  [[nodiscard]] const T* modal() const {
    return std::get_if<T>(&session_.modal());
  }

  [[nodiscard]] std::string last_toast() const {
    return session_.toasts().empty() ? "" : session_.toasts().back().text;
  }

  test::ScratchFolder folder_;
  std::vector<std::uint32_t> visible_{0, 2};
  Session session_{{[] {}, [this]() -> Result<std::vector<std::uint32_t>> { return visible_; }}};
};

}  // namespace limn::app
