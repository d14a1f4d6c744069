// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mb {

class StimulusBar;
class TrialsView;
class TuneColumn;
class TuneCommands;
class TunePlot;

/// What the Tune page shows; all of it belongs to the page.
struct TuneParts {
    TuneCommands *commands = nullptr;
    StimulusBar *stimulus = nullptr;
    TuneColumn *column = nullptr;
    TrialsView *trials = nullptr;
    TunePlot *plot = nullptr; ///< the live view
};

} // namespace mb
