// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tourstage.h"

namespace mb {

/// What the tour sees of a board with several axes: parameters of one, and a step of all at the same moment, on the page Tune and in a
/// plot. The stage outlives this. GUI thread.
class AxesTour {
public:
    explicit AxesTour(TourStage &stage)
        : m_stage(stage)
    {
    }
    void plan();

private:
    void planBoard();
    void planStep();
    void step(double target);
    [[nodiscard]] bool allMove() const { return m_stage.board()->motion.setPoints.size() == 4; }

    TourStage &m_stage;
};

} // namespace mb
