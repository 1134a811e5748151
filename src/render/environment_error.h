#pragma once

#include <stdexcept>

namespace limn::render {

/// The machine lacks what drawing needs: OpenGL 4.5, a library, a working shader compiler, memory.
/// The message is a full sentence for people and says what to do. Caught where the program turns
/// failures into exit codes, never in between.
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The graphics driver has no memory left for what is to be drawn. Less may fit.
class OutOfVideoMemory : public EnvironmentError {
 public:
  using EnvironmentError::EnvironmentError;
};

}  // namespace limn::render
