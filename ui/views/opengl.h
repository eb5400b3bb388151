#pragma once

namespace nineline::views {

/// The OpenGL format that the 3D views need; call before the application object is made.
void prepareOpenGl();

}  // namespace nineline::views
