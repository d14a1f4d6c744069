// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/framepermit.h"
#include "widgets/common/workbench.h"
#include "widgets/control/arming.h"
#include "widgets/monitor/typedframe.h"

#include <QFrame>
#include <QTimer>

class QCheckBox;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace mb {

class HoldButton;
class Segmented;
class WrapLayout;

/// Sends one frame by hand, once or again and again. It says what the frame means before it goes; one that makes a motor move wants an
/// armed device and a button held for a second, and its repetition ends in a stop of that device.
class SendPanel : public QFrame {
    Q_OBJECT
public:
    SendPanel(Workbench &workbench, Arming &arming, const ThemeSource &theme, QWidget *parent = nullptr);

    /// Address of the link that is sent to.
    void setLink(const std::string &link);
    void setFrame(const CanFrame &frame);
    [[nodiscard]] bool isRepeating() const { return m_repeat.isActive(); }
    /// Ends the repetition; a motor that it moved is stopped.
    void endRepeat(const QString &why = {});

protected:
    void hideEvent(QHideEvent *event) override;

private:
    void buildFields(WrapLayout &row);
    void follow();
    [[nodiscard]] FramePermit permit() const;
    [[nodiscard]] QString meaning() const;
    void activate();
    void send();
    void sent(const Result<void> &result);
    void say(const QString &text, Tone tone);

    Workbench &m_workbench;
    Arming &m_arming;
    const ThemeSource &m_theme;
    std::string m_link;
    TypedFrame m_typed;
    FramePermit m_permit;
    DeviceId m_moved; ///< by the repetition that runs
    bool m_moves = false;
    int m_waiting = 0;
    std::uint64_t m_sent = 0;
    QTimer m_repeat;
    QLineEdit *m_id = nullptr;
    Segmented *m_format = nullptr;
    QLineEdit *m_data = nullptr;
    QCheckBox *m_again = nullptr;
    QSpinBox *m_period = nullptr;
    HoldButton *m_send = nullptr;
    QLabel *m_meaning = nullptr;
    QLabel *m_outcome = nullptr;
};

} // namespace mb
