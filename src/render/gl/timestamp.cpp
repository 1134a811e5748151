#include "render/gl/timestamp.h"

#include "limn/contract.h"

namespace limn::render::gl {

void delete_query(GLuint id) {
  glDeleteQueries(1, &id);
}

Timestamp Timestamp::create() {
  GLuint id = 0;
  glCreateQueries(GL_TIMESTAMP, 1, &id);
  Timestamp timestamp;
  timestamp.handle_ = Handle<delete_query>(id);
  return timestamp;
}

void Timestamp::record() const {
  LIMN_EXPECTS(handle_);
  glQueryCounter(handle_.id(), GL_TIMESTAMP);
}

double Timestamp::seconds() const {
  LIMN_EXPECTS(handle_);
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(handle_.id(), GL_QUERY_RESULT, &nanoseconds);
  return static_cast<double>(nanoseconds) * 1e-9;
}

}  // namespace limn::render::gl
