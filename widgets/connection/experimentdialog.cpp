// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/experimentdialog.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/guarded.h"
#include "widgets/common/holdbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/stateglyph.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QListWidget>
#include <QProgressBar>
#include <QVBoxLayout>

namespace mb {

ExperimentDialog::ExperimentDialog(
    Workbench &workbench, DeviceId device, const Experiment &experiment, const ThemeSource &theme, QWidget *parent)
    : QDialog(parent)
    , m_workbench(workbench)
    , m_device(device)
    , m_experiment(experiment)
    , m_theme(theme)
    , m_renewal(workbench)
{
    const DeviceView *view = workbench.snapshot().device(device);
    setObjectName(QStringLiteral("experimentDialog"));
    setWindowTitle((view ? titleOf(*view) + QStringLiteral(" · ") : QString()) + tableText(experiment.title));
    auto *column = new QVBoxLayout(this);
    column->setSpacing(theme.theme().u(12));
    auto *explanation = textLabel(tableText(experiment.explanation), TextRole::Body, Tone::Text, this);
    explanation->setWordWrap(true);
    column->addWidget(explanation);
    buildQuestions(*column);
    buildProgress(*column);
    buildButtons(*column);
    setMinimumSize(theme.theme().u(520), theme.theme().u(520));
    m_renewal.setCondition([this] { // only while somebody can see it
        return m_running && isVisible() && QGuiApplication::applicationState() != Qt::ApplicationInactive;
    });
    connect(&workbench, &Workbench::changed, this, &ExperimentDialog::follow);
    connect(this, &QDialog::finished, this, &ExperimentDialog::cancel);
}

ExperimentDialog::~ExperimentDialog()
{
    cancel();
}

void ExperimentDialog::buildQuestions(QVBoxLayout &column)
{
    auto *form = new QFormLayout;
    form->setSpacing(m_theme.theme().u(8));
    const DeviceView *view = m_workbench.snapshot().device(m_device);
    m_axis = new QComboBox(this);
    m_axis->setAccessibleName(tr("Axis"));
    for (int axis = 1; view && axis <= view->family->capabilities.axes; ++axis)
        m_axis->addItem(tr("axis %1").arg(axis), axis);
    if (m_axis->count() > 1)
        form->addRow(tr("Of which motor"), m_axis);
    else
        m_axis->hide();
    if (m_experiment.power > 0.0) {
        m_power = new QDoubleSpinBox(this);
        m_power->setAccessibleName(tr("Most power"));
        m_power->setDecimals(0);
        m_power->setRange(5.0, m_experiment.mostPower * 100.0);
        m_power->setSingleStep(5.0);
        m_power->setSuffix(QStringLiteral(" %"));
        m_power->setValue(m_experiment.power * 100.0);
        form->addRow(tr("Most power"), m_power);
    }
    if (!m_experiment.answers.empty()) {
        m_answer = new QComboBox(this);
        m_answer->setAccessibleName(tableText(m_experiment.question));
        for (const std::string_view answer : m_experiment.answers)
            m_answer->addItem(tableText(answer));
        form->addRow(tableText(m_experiment.question), m_answer);
    }
    column.addLayout(form);
}

void ExperimentDialog::buildProgress(QVBoxLayout &column)
{
    m_step = textLabel(tr("Not begun"), TextRole::Body, Tone::Dim, this);
    m_step->setAccessibleName(tr("Step"));
    m_progress = new QProgressBar(this);
    m_progress->setAccessibleName(tr("Progress of the experiment"));
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(m_theme.theme().u(8));
    m_progress->setRange(0, 1);
    m_log = new QListWidget(this);
    m_log->setAccessibleName(tr("Log of the experiment"));
    m_log->setMinimumHeight(m_theme.theme().u(140));
    m_log->setWordWrap(true);
    m_log->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_result = textLabel({}, TextRole::Emphasis, Tone::Text, this);
    m_result->setAccessibleName(tr("Result"));
    m_result->setWordWrap(true);
    m_result->hide();
    column.addWidget(m_step);
    column.addWidget(m_progress);
    column.addWidget(m_log, 1);
    column.addWidget(m_result);
}

void ExperimentDialog::buildButtons(QVBoxLayout &column)
{
    auto *row = new QHBoxLayout;
    const bool moves = m_experiment.power > 0.0;
    if (moves)
        column.addWidget(textLabel(tr("STOP, Esc or Cancel ends it at any time."), TextRole::Caption, Tone::Dim, this));
    row->addStretch();
    m_close = new QPushButton(tr("Close"), this);
    m_close->setAutoDefault(false); // the Enter that is held to begin would cancel
    m_start = new HoldButton(m_theme, Symbol::Play, moves ? tr("Hold to turn the motor") : tr("Begin"), this);
    m_start->setObjectName(QStringLiteral("beginExperiment"));
    m_start->setPrimary(true);
    m_start->setHoldNeeded(moves);
    row->addWidget(m_close);
    row->addWidget(m_start);
    column.addLayout(row);
    connect(m_close, &QPushButton::clicked, this, [this] {
        if (m_running)
            cancel();
        else
            reject();
    });
    connect(m_start, &HoldButton::activated, this, &ExperimentDialog::start);
}

void ExperimentDialog::start()
{
    if (m_running)
        return;
    const OperationView *last = m_workbench.snapshot().operation(m_device);
    m_before = last ? last->id : OperationId{};
    m_running = true;
    m_lines = 0;
    m_log->clear();
    m_result->hide();
    m_start->setEnabled(false);
    m_close->setText(tr("Cancel"));
    ExperimentOptions options;
    options.axis = std::max(1, m_axis->currentData().toInt());
    options.power = m_power ? m_power->value() / 100.0 : 0.0;
    options.answer = m_answer ? m_answer->currentIndex() : 0;
    m_renewal.keep({m_device});
    m_workbench.send(orders::RunExperiment{m_device, std::string(m_experiment.key), options},
        guarded(this, [this](const Result<void> &result) { ended(result); }));
}

const OperationView *ExperimentDialog::operation() const
{
    const OperationView *last = m_workbench.snapshot().operation(m_device);
    return last && last->id > m_before ? last : nullptr;
}

void ExperimentDialog::follow()
{
    const OperationView *now = m_lines > 0 || m_running ? operation() : nullptr;
    if (!now)
        return;
    if (m_running) {
        m_step->setText(messageText(now->status.step));
        setTone(*m_step, Tone::Text);
    }
    m_progress->setRange(0, std::max(now->status.total, 1));
    m_progress->setValue(now->status.done);
    for (; m_lines < now->status.log.size(); ++m_lines) {
        const LogLine &line = now->status.log[m_lines];
        const GlyphState state = line.severity == Severity::Good ? GlyphState::Done
            : line.severity == Severity::Caution                 ? GlyphState::Warning
            : line.severity == Severity::Danger                  ? GlyphState::Fault
                                                                 : GlyphState::Volatile;
        m_log->addItem(new QListWidgetItem(glyphIcon(state, m_theme.theme()), messageText(line.text)));
        m_log->scrollToBottom();
    }
}

void ExperimentDialog::cancel()
{
    if (const OperationView *now = m_running ? operation() : nullptr)
        m_workbench.send(orders::CancelOperation{now->id});
}

void ExperimentDialog::ended(const Result<void> &result)
{
    follow();
    m_running = false;
    m_renewal.keep({});
    m_start->setEnabled(true);
    m_close->setText(tr("Close"));
    m_step->setText(tr("Ended"));
    m_result->setText(result ? tr("Found and kept for this device.")
            : result.error().fault == Fault::Cancelled
            ? tr("Cancelled. The motor is stopped; gains and limits are as they were.")
            : errorText(result.error()));
    setTone(*m_result, result ? Tone::Ok : Tone::Danger);
    m_result->show();
}

QString ExperimentDialog::result() const
{
    return m_result->isHidden() ? QString() : m_result->text();
}

} // namespace mb
