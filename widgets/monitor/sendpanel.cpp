// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/sendpanel.h"

#include "model/registry.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/guarded.h"
#include "widgets/common/holdbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/segmented.h"
#include "widgets/common/wraplayout.h"
#include "widgets/monitor/frametext.h"

#include <QApplication>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSpinBox>
#include <QVBoxLayout>

namespace mb {

SendPanel::SendPanel(Workbench &workbench, Arming &arming, const ThemeSource &theme, QWidget *parent)
    : QFrame(parent)
    , m_workbench(workbench)
    , m_arming(arming)
    , m_theme(theme)
{
    setAccessibleName(tr("Send a frame"));
    setStyleProperty(*this, "card", true);
    auto *column = new QVBoxLayout(this);
    const int pad = theme.theme().u(10);
    column->setContentsMargins(pad, pad, pad, pad);
    column->setSpacing(theme.theme().u(6));
    auto *row = new WrapLayout;
    buildFields(*row);
    column->addLayout(row);
    m_meaning = new ElidedLabel({}, this);
    m_outcome = textLabel({}, TextRole::Body, Tone::Dim, this);
    column->addWidget(m_meaning);
    column->addWidget(m_outcome);
    m_outcome->hide();
    m_repeat.setTimerType(Qt::PreciseTimer);
    connect(&m_repeat, &QTimer::timeout, this, &SendPanel::send);
    connect(&workbench, &Workbench::changed, this, &SendPanel::follow);
    connect(&arming, &Arming::changed, this, &SendPanel::follow);
    connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (state == Qt::ApplicationInactive && m_moves) // no set-point of ours runs: the window would stop nothing
            endRepeat(tr("the window lost the focus"));
    });
    follow();
}

void SendPanel::buildFields(WrapLayout &row)
{
    const Theme &theme = m_theme.theme();
    m_id = new QLineEdit(this);
    m_id->setAccessibleName(tr("Identifier"));
    m_id->setPlaceholderText(tr("id, such as 7FF"));
    m_id->setToolTip(tr("Hexadecimal; a whole frame such as 02061405#8125 may be pasted here"));
    m_id->setFixedWidth(theme.u(150));
    m_format = new Segmented(tr("Length of the identifier"), {tr("11 bits"), tr("29 bits")}, this);
    m_data = new QLineEdit(this);
    m_data->setAccessibleName(tr("Data"));
    m_data->setPlaceholderText(tr("data, such as 81 25 11"));
    m_data->setFixedWidth(theme.u(220));
    m_again = new QCheckBox(tr("Repeat every"), this);
    m_period = new QSpinBox(this);
    m_period->setAccessibleName(tr("Period"));
    m_period->setRange(5, 10000);
    m_period->setValue(100);
    m_period->setSuffix(tr(" ms"));
    m_send = new HoldButton(m_theme, Symbol::FrameSend, tr("Send"), this);
    m_send->setTextVariants({tr("Send"), tr("Hold to send"), tr("End repeating")});
    for (QWidget *field :
        {static_cast<QWidget *>(m_id), static_cast<QWidget *>(m_format), static_cast<QWidget *>(m_data),
            static_cast<QWidget *>(m_again), static_cast<QWidget *>(m_period), static_cast<QWidget *>(m_send)})
        row.addWidget(field);
    connect(m_id, &QLineEdit::textChanged, this, &SendPanel::follow);
    connect(m_data, &QLineEdit::textChanged, this, &SendPanel::follow);
    connect(m_format, &Segmented::currentChanged, this, &SendPanel::follow);
    connect(m_period, QOverload<int>::of(&QSpinBox::valueChanged), this,
        [this](int period) { m_repeat.setInterval(period); });
    connect(m_send, &HoldButton::activated, this, &SendPanel::activate);
}

void SendPanel::setLink(const std::string &link)
{
    if (link == m_link)
        return;
    endRepeat();
    m_link = link;
    say({}, Tone::Dim);
    follow();
}

void SendPanel::setFrame(const CanFrame &frame)
{
    endRepeat();
    m_format->setCurrent(frame.extended ? 1 : 0);
    m_id->setText(frame.remote ? QString::fromStdString(toText(frame)) : hexId(frame));
    m_data->setText(frame.remote ? QString() : hexBytes(frame));
    m_id->setFocus();
}

void SendPanel::follow()
{
    m_typed = readTypedFrame(m_id->text(), m_format->current() == 1, m_data->text());
    m_permit = m_typed.frame ? permit() : FramePermit{};
    const bool empty = m_id->text().trimmed().isEmpty();
    const QString problem = m_permit.refusal ? messageText(m_permit.refusal->message())
        : empty                              ? QString()
                                             : m_typed.problem;
    if (isRepeating() && (!m_typed.frame || m_permit.refusal))
        endRepeat(m_typed.frame ? problem : m_typed.problem);
    m_id->setEnabled(!isRepeating());
    m_data->setEnabled(!isRepeating());
    m_format->setEnabled(!isRepeating());
    m_send->setHoldNeeded(m_permit.control && !isRepeating());
    m_send->setRole(isRepeating() ? tr("End repeating") : m_permit.control ? tr("Hold to send") : tr("Send"));
    m_send->setEnabled(isRepeating() || (m_typed.frame && problem.isEmpty()));
    QString shown = !problem.isEmpty() ? problem
        : empty                        ? tr("What is typed here is decoded before it is sent")
                                       : meaning();
    if (problem.isEmpty() && m_permit.control)
        shown = tr("Makes a motor move: %1").arg(shown);
    m_meaning->setText(shown);
    setTone(*m_meaning, !problem.isEmpty() ? Tone::Danger : m_permit.control ? Tone::Caution : Tone::Dim);
}

FramePermit SendPanel::permit() const
{
    return permitFor(*m_typed.frame, m_link, m_workbench.snapshot(), families(),
        [this](DeviceId device) { return m_arming.isArmed(device); });
}

QString SendPanel::meaning() const
{
    const auto &meaning = m_permit.meaning;
    return !meaning ? tr("no decoder knows this identifier")
                    : tr("%1 of %2 #%3   %4")
                          .arg(qt(meaning->frame.message), qt(meaning->family->title))
                          .arg(meaning->frame.address)
                          .arg(fieldsLine(meaning->frame));
}

void SendPanel::activate()
{
    if (isRepeating()) {
        endRepeat(tr("ended"));
        return;
    }
    follow();
    if (!m_typed.frame || m_permit.refusal)
        return;
    m_sent = 0;
    if (m_again->isChecked()) {
        m_moves = m_permit.control;
        m_moved = m_permit.device;
        m_repeat.start(m_period->value());
    }
    send();
    follow();
}

void SendPanel::send()
{
    // Judged again each time: STOP, disarming or another master must end this at once.
    const FramePermit now = permit();
    if (now.refusal)
        return endRepeat(errorText(*now.refusal));
    constexpr int mostWaiting = 50;
    if (m_waiting >= mostWaiting)
        return endRepeat(tr("The link does not take frames as fast as they are sent"));
    ++m_waiting;
    const auto armed = now.control ? std::optional(now.device) : std::nullopt;
    m_workbench.send(orders::SendFrame{m_link, *m_typed.frame, armed},
        guarded(this, [this](const Result<void> &result) { sent(result); }));
}

void SendPanel::sent(const Result<void> &result)
{
    --m_waiting;
    if (!result) {
        endRepeat();
        say(errorText(result.error()), Tone::Danger);
        return;
    }
    ++m_sent;
    say(tr("%1 sent").arg(formatCount(static_cast<qint64>(m_sent))), Tone::Ok);
}

void SendPanel::endRepeat(const QString &why)
{
    if (!isRepeating())
        return;
    m_repeat.stop();
    if (m_moves)
        m_workbench.send(orders::StopMotion{m_moved});
    m_moves = false;
    if (!why.isEmpty())
        say(tr("%1 sent, then: %2").arg(formatCount(static_cast<qint64>(m_sent)), why), Tone::Caution);
    follow();
}

void SendPanel::say(const QString &text, Tone tone)
{
    m_outcome->setText(text);
    m_outcome->setVisible(!text.isEmpty());
    setTone(*m_outcome, tone);
}

void SendPanel::hideEvent(QHideEvent *event)
{
    endRepeat(tr("the page was left"));
    QFrame::hideEvent(event);
}

} // namespace mb
