#include "algorithms/gl/gl_context.h"

#include <epoxy/gl.h>
#include <optional>
#include <thread>

#include "algorithms/gl/gl_objects.h"
#include "tests/catch.h"
#include "tests/gl/parking.h"
#include "tests/gl_loss.h"

using namespace svchain;
using namespace svchain::gl;
using namespace svchain::testing;
using Catch::Matchers::Contains;

TEST_CASE("a GL context says what draws, and contexts come and go in any order") {
  if (!has_gl()) return;
  std::optional<GlContext> first(std::in_place), second(std::in_place);
  CHECK_FALSE(first->renderer().empty());
  CHECK_THAT(first->version(), Contains("OpenGL ES 3"));
  first.reset();
  {
    const GlContext::Use use(*second);
    CHECK_NOTHROW(second->require_not_lost());
  }
  first.emplace();
  second.reset();
  const GlContext::Use use(*first);
  CHECK_NOTHROW(first->require_not_lost());
}

TEST_CASE("a thread uses one GL context at a time, and a context is used by one thread at a time") {
  if (!has_gl()) return;
  const GlContext one, other;
  const GlContext::Use use(one);
  CHECK_NOTHROW(GlContext::Use(one));
  CHECK_THROWS_WITH(GlContext::Use(other), Contains("already uses another context"));
  std::string said;
  std::thread([&] {
    try {
      const GlContext::Use elsewhere(one);
    } catch (const std::runtime_error& error) {
      said = error.what();
    }
  }).join();
  CHECK_THAT(said, Contains("EGL_BAD_ACCESS"));
}

TEST_CASE("a reset of the GPU is a lost context, whoever is guilty") {
  CHECK_NOTHROW(require_no_reset(GL_NO_ERROR));
  CHECK_THROWS_AS(require_no_reset(GL_GUILTY_CONTEXT_RESET), GlLost);
  CHECK_THROWS_AS(require_no_reset(GL_UNKNOWN_CONTEXT_RESET), GlLost);
  CHECK_THROWS_WITH(require_no_reset(GL_INNOCENT_CONTEXT_RESET), Contains("because of another context"));
}

TEST_CASE("shaders that do not compile or link are refused with what the compiler says") {
  if (!has_gl()) return;
  const GlContext context;
  const GlContext::Use use(context);
  const std::string head = "#version 300 es\nprecision highp float;\n";
  const std::string vertex = head + "void main() { gl_Position = vec4(0.0); }";
  const std::string fragment = head + "in vec3 nowhere; out vec4 c; void main() { c = vec4(nowhere, 1.0); }";
  CHECK_THROWS_WITH(Program("nonsense", fragment), Contains("vertex shader does not compile"));
  CHECK_THROWS_WITH(Program(vertex, head + "void main() { unheard_of(); }"),
                    Contains("fragment shader does not compile") && Contains("unheard_of"));
  CHECK_THROWS_WITH(Program(vertex, fragment), Contains("do not link") && Contains("nowhere"));
}

TEST_CASE("a context that the driver gives up is lost to whoever draws, who then may make another") {
  if (!has_gl()) return;
  const GlContext context;
  const auto renderer = renderer_of_parking(context);
  const bowl::Viewpoint top = parking().preset("top");
  const auto tones = synthesis::ToneMapping::identity();
  const cv::Mat before = drawn(*renderer, parking().bgr, tones, top);
  {
    const GlLoss loss(GlLoss::Kind::kAlways);
    CHECK_THROWS_AS(drawn(*renderer, parking().bgr, tones, top), GlLost);
    CHECK_THROWS_AS(renderer->set_mesh(parking().mesh.table(), parking().rig), GlLost);
    CHECK_THROWS_AS(renderer->set_car(parking().car, parking().rig.vehicle), GlLost);
  }
  const GlContext other;
  CHECK(cv::norm(drawn(*renderer_of_parking(other), parking().bgr, tones, top), before, cv::NORM_INF) == 0);
  const GlLoss gone(GlLoss::Kind::kForGood);
  CHECK_THROWS_WITH(GlContext(), Contains("eglCreateContext") && Contains("EGL_BAD_ALLOC"));
}
