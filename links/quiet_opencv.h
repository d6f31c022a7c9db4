#pragma once
// What goes wrong with pictures and videos is reported once, by us.

namespace svchain {

/// OpenCV and the FFmpeg in it write no log of their own, unless the user's environment asks for one. Before
/// the first picture or video is opened, while there is one thread.
void quiet_opencv();

}  // namespace svchain
