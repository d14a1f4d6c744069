// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/closing.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/serviceview.h"
#include "widgets/common/updates.h"
#include "widgets/control/arming.h"

#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

namespace mb {
namespace {

constexpr int lookEvery = 100; // ms

bool isRunningTrial(const OperationView &job)
{
    return job.status.state == OperationStatus::State::Running && job.status.kind == OperationKind::Trial;
}

} // namespace

Closing::Closing(Workbench &workbench, Arming &arming, QWidget &window)
    : QObject(&window)
    , m_workbench(workbench)
    , m_arming(arming)
    , m_window(window)
{
    connect(&workbench, &Workbench::changed, this, &Closing::follow);
    connect(&workbench, &Workbench::serviceChanged, this, &Closing::follow);
    m_look.setInterval(lookEvery);
    connect(&m_look, &QTimer::timeout, this, &Closing::follow);
}

bool Closing::isServing() const
{
    return m_workbench.service().running;
}

bool Closing::mayClose()
{
    m_within = true;
    if (m_state == State::Open) {
        if (isServing())
            askAboutService();
        else if (runningUpdates(m_workbench.snapshot()).empty())
            begin();
        else
            askAboutUpdates();
    } else if (m_question) {
        m_question->raise();
    }
    m_within = false;
    return m_state == State::Free;
}

void Closing::end()
{
    m_asks = false;
    if (m_question)
        m_question->close();
    if (isServing())
        m_workbench.send(orders::CancelService{});
    if (m_state == State::Open || (m_state == State::Asking && m_moved.empty()))
        begin();
    else if (m_state == State::Asking)
        leave();
}

QAbstractButton &Closing::ask(const QString &question, const QString &what, const QString &go)
{
    m_state = State::Asking;
    auto *box
        = new QMessageBox(QMessageBox::Warning, tr("Close MotorBench"), question, QMessageBox::NoButton, &m_window);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(what);
    QPushButton *leaveButton = box->addButton(go, QMessageBox::DestructiveRole);
    QPushButton *stay = box->addButton(tr("Keep open"), QMessageBox::RejectRole);
    leaveButton->setAccessibleName(go);
    stay->setAccessibleName(stay->text());
    box->setDefaultButton(stay);
    box->setEscapeButton(stay);
    connect(stay, &QPushButton::clicked, this, &Closing::keepOpen);
    m_question = box;
    box->open();
    return *leaveButton;
}

void Closing::askAboutUpdates()
{
    const Snapshot &shot = m_workbench.snapshot();
    QStringList places;
    bool critical = false;
    for (const OperationView *update : runningUpdates(shot)) {
        places += placeOf(shot, *update);
        critical = critical || !update->status.mayInterrupt;
    }
    QAbstractButton &go
        = ask(tr("Firmware is being written to %1. Cancel the update?").arg(places.join(QStringLiteral(", "))),
            critical ? tr("What is written now must not be cut: the window closes once it is over.")
                     : tr("The unit then waits in its bootloader, and the update can be run again."),
            tr("Cancel the update and close"));
    connect(&go, &QAbstractButton::clicked, this, &Closing::begin);
}

void Closing::askAboutService()
{
    const auto &rows = m_workbench.service().rows;
    const bool critical = std::ranges::any_of(rows, [](const service::QueueRow &row) { return !row.mayInterrupt; });
    QAbstractButton &go = ask(tr("Units are being served. Cancel the queue?"),
        critical ? tr("What is written now must not be cut: the window closes once it is over.")
                 : tr("The journal knows where it stood, and the queue can be gone on with."),
        tr("Cancel the queue and close"));
    connect(&go, &QAbstractButton::clicked, this, [this] {
        m_workbench.send(orders::CancelService{});
        begin();
    });
}

void Closing::askAboutMotors()
{
    QAbstractButton &go
        = ask(tr("%1 has not been seen to stop. Close anyway?").arg(turning().join(QStringLiteral(", "))),
            tr("It was told to stop. Without this window nobody sees whether it does."), tr("Close anyway"));
    connect(&go, &QAbstractButton::clicked, this, &Closing::leave);
}

void Closing::begin()
{
    m_state = State::Ending;
    m_moved.clear();
    for (const DeviceView &device : m_workbench.snapshot().devices) {
        if (device.motion.running)
            m_moved.push_back(device.id);
    }
    for (const OperationView &job : m_workbench.snapshot().operations) { // also between their motions
        if (isRunningTrial(job))
            m_moved.push_back(job.device);
    }
    m_since = m_workbench.now();
    if (m_asks && isPuttingBack())
        m_workbench.report(
            Severity::Info, {}, tr("The window closes once the experiment has put back what it changed."));
    m_arming.disarm();
    for (const DeviceId device : m_moved)
        m_workbench.send(orders::StopMotion{device});
    m_look.start();
    follow();
}

bool Closing::isPuttingBack() const
{
    const auto &jobs = m_workbench.snapshot().operations;
    return (m_arming.isOnTrial() || std::ranges::any_of(jobs, isRunningTrial))
        && m_workbench.now() - m_since <= longestPuttingBack;
}

void Closing::follow()
{
    if (m_state == State::Asking && m_question && m_moved.empty() && !isServing()
        && runningUpdates(m_workbench.snapshot()).empty()) {
        m_question->close(); // it is over: nothing to ask any more
        keepOpen();
        return;
    }
    if (m_state == State::Asking && !m_moved.empty() && turning().isEmpty()) {
        m_question->close();
        leave();
        return;
    }
    if (m_state != State::Ending || !endUpdates())
        return;
    if (turning().isEmpty()) {
        if (!isPuttingBack())
            leave();
    } else if (m_workbench.now() - m_since > patience) {
        m_asks ? askAboutMotors() : leave();
    }
}

/// Whether none runs any more.
bool Closing::endUpdates()
{
    const auto updates = runningUpdates(m_workbench.snapshot());
    for (const OperationView *update : updates) {
        if (update->status.mayInterrupt)
            m_workbench.send(orders::CancelOperation{update->id});
    }
    const bool all = updates.empty() && !isServing();
    if (!all)
        m_since = m_workbench.now();
    return all;
}

QStringList Closing::turning() const
{
    QStringList names;
    for (const DeviceId id : m_moved) {
        const DeviceView *device = m_workbench.snapshot().device(id);
        if (device && (device->motion.running || device->liveness.moving || !device->liveness.heard))
            names += titleOf(*device);
    }
    return names;
}

void Closing::keepOpen()
{
    m_state = State::Open;
    m_look.stop();
    m_moved.clear();
}

void Closing::leave()
{
    m_state = State::Free;
    m_look.stop();
    m_unstopped = turning();
    if (!m_within)
        m_window.close();
}

} // namespace mb
