// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/autotune.h"
#include "tuning/frequencyresponse.h"
#include "widgets/control/arming.h"
#include "widgets/design/designbook.h"

#include <QWidget>

class QLabel;

namespace mb {

class CommandButton;

/// Measures the motor by stepped sines on the model that is known: the button, and beside it what will happen, in duty, speed, travel
/// and time, before anything moves. Motion goes through Arming, STOP ends it.
class SweepPanel : public QWidget {
    Q_OBJECT
public:
    SweepPanel(Arming &arming, const ThemeSource &theme, QWidget *parent);

    /// Of this motor now. Nothing is known, or `report` has no model: the panel is empty.
    struct State {
        DesignPlace place;
        const Family *family = nullptr;
        const tuning::TuneReport *report = nullptr;
        Envelope inForce;
        Envelope entered;
        bool mayRun = false;
    };
    void follow(const State &state);
    /// As if the button was pressed.
    void measure();
    [[nodiscard]] QString announcement() const;

Q_SIGNALS:
    /// To its end, of the motor that it began with.
    void measured(const mb::DesignPlace &place, const mb::tuning::FrequencyResponse &response);

private:
    Arming &m_arming;
    CommandButton *m_button = nullptr;
    QLabel *m_words = nullptr;
    std::optional<tuning::SweepPlan> m_plan;
    tuning::PlantModel m_plant;
    DesignPlace m_place;
    bool m_mayRun = false;
};

} // namespace mb
