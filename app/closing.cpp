// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/closing.h"

#include "widgets/common/devicetext.h"
#include "widgets/control/arming.h"
#include "widgets/control/motionwords.h"

#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

namespace mb {
namespace {

constexpr int lookEvery = 100; // ms

struct Words {
    QString question;
    QString detail; ///< where it may be cut now
    QString go;
};

Words wordsOf(Unfinished::Kind kind, const QString &places, const QString &left)
{
    switch (kind) {
    case Unfinished::Kind::Service:
        return {Closing::tr("Units are being served. Cancel the queue?"),
            Closing::tr("The journal knows where it stood, and the queue can be gone on with."),
            Closing::tr("Cancel the queue and close")};
    case Unfinished::Kind::Export:
        return {Closing::tr("Samples are being written to %1. Cancel the export?").arg(places),
            Closing::tr("Nothing of it is kept then."), Closing::tr("Cancel the export and close")};
    case Unfinished::Kind::Update:
        return {Closing::tr("Firmware is being written to %1. Cancel the update?").arg(places), left,
            Closing::tr("Cancel the update and close")};
    case Unfinished::Kind::Job: break;
    }
    return {};
}

/// This program has moved it, or knows that it moves, and nobody has seen it stand since it was told to stop, if it was. One that its
/// own watchdog has switched off before is out of it.
bool mayMove(const DeviceView &device)
{
    return device.motion.running || (device.stopsMotion && device.stop != StopState::ByWatchdog);
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

bool Closing::mayClose()
{
    m_within = true;
    if (m_state == State::Open)
        askOrBegin();
    else if (m_question)
        m_question->raise();
    m_within = false;
    return m_state == State::Free;
}

void Closing::end()
{
    m_asks = false;
    if (m_question)
        m_question->close();
    if (m_state == State::Open || (m_state == State::Asking && m_about))
        begin();
    else if (m_state == State::Asking)
        leave();
}

/// About one kind after the other.
void Closing::askOrBegin()
{
    const std::vector<Unfinished> all = unfinishedIn(m_window, m_workbench);
    const auto next = std::ranges::find_if(
        all, [this](const Unfinished &one) { return one.kind != Unfinished::Kind::Job && one.kind > m_about; });
    if (next == all.end())
        return begin();
    m_about = next->kind;
    QStringList places;
    for (const Unfinished &one : all) {
        if (one.kind == m_about)
            places += one.what;
    }
    const Words words = wordsOf(next->kind, places.join(QStringLiteral(", ")), {});
    const QAbstractButton &go = ask(words.question, detailOf(all), words.go);
    connect(&go, &QAbstractButton::clicked, this, &Closing::askOrBegin);
}

/// What becomes of those that are asked about, as they are now.
QString Closing::detailOf(const std::vector<Unfinished> &all) const
{
    QStringList left;
    bool critical = false;
    for (const Unfinished &one : all) {
        if (one.kind != m_about)
            continue;
        left += one.left;
        critical = critical || !one.mayInterrupt;
    }
    left.removeDuplicates();
    return critical ? tr("What is written now must not be cut: the window closes once it is over.")
                    : wordsOf(*m_about, {}, left.join(QLatin1Char(' '))).detail;
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

void Closing::askAboutMotors()
{
    m_about.reset();
    QAbstractButton &go
        = ask(tr("%1 has not been seen to stop. Close anyway?").arg(turning().join(QStringLiteral(", "))),
            tr("It was told to stop. Without this window nobody sees whether it does."), tr("Close anyway"));
    connect(&go, &QAbstractButton::clicked, this, &Closing::leave);
}

void Closing::begin()
{
    m_state = State::Ending;
    m_since = m_workbench.now();
    m_moved.clear();
    for (const DeviceView &device : m_workbench.snapshot().devices) {
        if (mayMove(device))
            m_moved.push_back(device.id);
    }
    QStringList awaited;
    for (const Unfinished &one : unfinishedIn(m_window, m_workbench)) {
        if (one.kind == Unfinished::Kind::Job)
            awaited += one.what;
        if (one.cancel && one.kind != Unfinished::Kind::Update)
            one.cancel();
    }
    if (m_asks && !awaited.isEmpty())
        m_workbench.report(Severity::Info, {},
            tr("The window closes once this has ended: %1").arg(awaited.join(QStringLiteral(", "))));
    m_arming.disarm();
    for (const DeviceId device : m_moved)
        m_workbench.send(orders::StopMotion{device});
    m_look.start();
    follow();
}

void Closing::follow()
{
    if (m_state == State::Asking)
        return followQuestion();
    if (m_state != State::Ending)
        return;
    bool cuts = false;
    bool waits = m_arming.isOnTrial();
    for (const Unfinished &one : unfinishedIn(m_window, m_workbench)) {
        if (one.kind == Unfinished::Kind::Update && one.mayInterrupt)
            one.cancel();
        (one.kind == Unfinished::Kind::Job ? waits : cuts) = true;
    }
    if (cuts) {
        m_since = m_workbench.now();
        return;
    }
    const Duration time = m_workbench.now() - m_since;
    const bool stands = turning().isEmpty();
    if (stands && (!waits || time > longestJob))
        leave();
    else if (!stands && time > patience)
        m_asks ? askAboutMotors() : leave();
}

/// What is over needs no answer any more.
void Closing::followQuestion()
{
    const std::vector<Unfinished> all = unfinishedIn(m_window, m_workbench);
    const auto isMeant = [this](const Unfinished &one) { return one.kind == m_about; };
    if (m_about && m_question)
        m_question->setInformativeText(detailOf(all));
    if (m_about ? std::ranges::any_of(all, isMeant) : !turning().isEmpty())
        return;
    if (m_question)
        m_question->close();
    m_about ? keepOpen() : leave();
}

QStringList Closing::turning() const
{
    const Snapshot &shot = m_workbench.snapshot();
    QStringList names;
    for (const DeviceView &device : shot.devices) {
        const bool isMoved = std::ranges::find(m_moved, device.id) != m_moved.end();
        if (mayMove(device) || (isMoved && device.stopsMotion))
            names += titleOf(device);
    }
    return names + namesOwed(shot);
}

void Closing::keepOpen()
{
    m_state = State::Open;
    m_look.stop();
    m_moved.clear();
    m_about.reset();
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
