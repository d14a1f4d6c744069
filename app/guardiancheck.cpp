// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardiancheck.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/spoken.h"

#include <QProcess>
#include <QPushButton>

namespace mb {
namespace {

constexpr int refusesToServe = 2; ///< its status where nobody gives it a line to watch

} // namespace

GuardianCheck::GuardianCheck(const QString &program, QWidget *parent)
    : QWidget(parent)
    , m_program(program)
    , m_words(textLabel(tr("stops a motor when this program is killed or hangs"), TextRole::Body, Tone::Dim, this))
    , m_ask(new QPushButton(tr("Check"), this))
    , m_process(new QProcess(this))
{
    auto *row = layoutIn<QHBoxLayout>(this);
    row->addWidget(m_words, 1);
    row->addWidget(m_ask);
    m_words->setWordWrap(true);
    m_ask->setAccessibleName(tr("Check the guardian"));
    m_ask->setAutoDefault(false);
    connect(m_ask, &QPushButton::clicked, this, &GuardianCheck::check);
    connect(m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            say(tr("%1 cannot be started: %2").arg(m_program, m_process->errorString()), false);
    });
    connect(m_process, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), this,
        [this](int status, QProcess::ExitStatus how) {
            const bool good = how == QProcess::NormalExit && status == refusesToServe;
            say(good ? tr("It is in place and runs.") : tr("%1 does not run as it should.").arg(m_program), good);
        });
}

void GuardianCheck::check()
{
    m_ask->setEnabled(false);
    m_process->start(m_program, QStringList());
}

void GuardianCheck::say(const QString &words, bool good)
{
    m_ask->setEnabled(true);
    m_words->setText(words);
    setTone(*m_words, good ? Tone::Ok : Tone::Danger);
    announce(*m_words, words);
}

} // namespace mb
