#pragma once
// A rig to start from where nobody knows how the cameras stand (the paper: "estimated from the frame content
// itself"). Of the given rig only the vehicle and the lenses are used: each camera is taken to look out at
// the middle of its side of the vehicle, and how high it is and how far it looks down is found by trying
// which way its picture, laid on the ground, shows the most of the charts; what is flat and square sets it
// right (levelling.h). The vehicle's size gives the place; the squares give the scale. Good to about 10
// degrees and a tenth of the vehicle's length. Pure.

#include "algorithms/calibration/calibration.h"

namespace svchain::calibration {

/// Replaces the nominal poses by what the pictures tell, and says how well those are known. Where a picture
/// shows no chart its camera stays where it was taken to be. Throws as calibrate() does.
void start_from_content(CalibrationInput& input);

}  // namespace svchain::calibration
