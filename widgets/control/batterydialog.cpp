// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/batterydialog.h"

#include "experiment/envelope.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/guarded.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/trialwords.h"
#include "widgets/control/wrappedlabel.h"
#include "widgets/plots/curvelegend.h"
#include "widgets/plots/curveplot.h"

#include <QHeaderView>
#include <QShortcut>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace mb {
namespace {

constexpr int dialogWidth = 720; // u
constexpr int dialogHeight = 620;
constexpr double samePlace = 0.02; ///< of the way from one end to the other
constexpr std::array<std::string_view, 5> columns{"rise", "settle", "overshoot", "sse", "peak_current"};

QString cellText(std::string_view key, const std::optional<double> &value)
{
    const MetricWord word = metricWord(key);
    return value ? formatNumber(*value * word.scale, word.decimals) : QString(UnknownMark);
}

double sizeOf(const tuning::Trial &trial)
{
    return trial.stimulus.to - trial.stimulus.from;
}

QString textOf(const BatteryOffer &offer)
{
    if (!offer.whyNot.isEmpty() || offer.battery.steps.empty())
        return BatteryDialog::tr("Not run: %1").arg(offer.whyNot);
    const auto &steps = offer.battery.steps;
    return BatteryDialog::tr(
        "%1 steps, both ways in turn, from %2 to %3 %4, with the gains in force. The motor turns; each step keeps "
        "inside the limits of the page.")
        .arg(steps.size())
        .arg(formatSignificant(steps.front().to, 4), formatSignificant(steps.back().to, 4), offer.unit);
}

bool isSameMotor(const BatteryOffer &a, const BatteryOffer &b)
{
    return a.device == b.device && a.motor == b.motor;
}

/// What somebody decides by. A position loop begins where the motor is, which may be another count by now.
bool isAlike(const BatteryOffer &a, const BatteryOffer &b)
{
    const auto &one = a.battery.steps;
    const auto &other = b.battery.steps;
    if (!isSameMotor(a, b) || a.unit != b.unit || a.whyNot != b.whyNot || one.size() != other.size())
        return false;
    const bool places = !one.empty() && one.front().mode == Mode::Position;
    const double most = places ? samePlace * std::abs(one.front().to - one.back().to) : 0.0;
    return std::ranges::equal(
        one, other, [most](const auto &x, const auto &y) { return std::abs(x.to - y.to) <= most; });
}

} // namespace

BatteryDialog::BatteryDialog(
    Arming &arming, std::function<BatteryOffer()> offer, const ThemeSource &theme, QWidget *parent)
    : QDialog(parent)
    , m_arming(arming)
    , m_offer(std::move(offer))
    , m_theme(theme)
{
    setWindowTitle(tr("Battery of steps"));
    setModal(false);
    const Theme &look = theme.theme();
    resize(look.u(dialogWidth), look.u(dialogHeight));
    auto *column = new QVBoxLayout(this);
    m_words = wrappedLabel({}, TextRole::Body, Tone::Text, this);
    m_start = new CommandButton(theme, Symbol::Play, tr("Run the battery"), this);
    m_start->setPrimary(true);
    m_start->setKeyHint(QStringLiteral("F7"));
    auto *const key = new QShortcut(Qt::Key_F7, this);
    key->setAutoRepeat(false); // it may have opened this
    m_start->setAutoDefault(false);
    buildTable();
    m_plot = new CurvePlot(theme, tr("Responses of the battery over each other"), this);
    m_plot->setAxes(tr("s"), tr("share of the step"), false);
    m_plot->setSurroundings({false, false});
    column->addWidget(m_words);
    column->addWidget(m_start, 0, Qt::AlignLeft);
    column->addWidget(m_table, 3);
    column->addWidget(namesOfWays(theme));
    column->addWidget(m_plot, 3);
    connect(m_start, &QPushButton::clicked, this, &BatteryDialog::run);
    connect(key, &QShortcut::activated, this, &BatteryDialog::run);
    connect(&arming, &Arming::changed, this, &BatteryDialog::follow);
}

void BatteryDialog::buildTable()
{
    m_table = new QTableWidget(0, static_cast<int>(columns.size()) + 1, this);
    m_table->setAccessibleName(tr("Steps of the battery and the worst of each metric"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setTextElideMode(Qt::ElideRight);
}

/// All of them have one colour; how each way is drawn is what tells them apart.
QWidget *BatteryDialog::namesOfWays(const ThemeSource &theme)
{
    auto *names = new CurveLegend(theme, tr("Responses over each other"), this);
    TraceLook look;
    look.role = TraceRole::Velocity;
    look.dash = TraceDash::Solid;
    std::vector<CurveLegend::Entry> entries{{tr("forwards"), look, CurveLegend::Shape::Line}};
    look.dash = TraceDash::Long;
    entries.push_back({tr("backwards"), look, CurveLegend::Shape::Line});
    names->setEntries(entries);
    return names;
}

void BatteryDialog::showOffer()
{
    if (m_running)
        return;
    m_isRefused = false;
    take(m_offer());
}

void BatteryDialog::followOffer()
{
    if (!isVisible() || m_running || words() != offered())
        return;
    BatteryOffer now = m_offer();
    if (isSameMotor(now, m_now) && textOf(now) == textOf(m_now))
        return;
    m_isRefused = m_isRefused && isAlike(now, m_now);
    take(std::move(now));
}

QString BatteryDialog::offered() const
{
    return m_isRefused ? tr("Not started, the page has changed: %1").arg(textOf(m_now)) : textOf(m_now);
}

void BatteryDialog::take(BatteryOffer offer)
{
    m_now = std::move(offer);
    say(offered());
    follow();
    if (!m_now.whyNot.isEmpty())
        return;
    setWindowTitle(tr("Battery of steps") + QStringLiteral(" · ") + m_now.motor);
    m_trials.clear();
    m_table->setRowCount(0);
    QStringList heads{tr("Step, %1").arg(m_now.unit)};
    for (const std::string_view key : columns) {
        const MetricWord word = metricWord(key);
        heads << (word.unit.isEmpty() ? word.name : word.name + QStringLiteral(", ") + word.unit);
    }
    m_table->setHorizontalHeaderLabels(heads);
    m_plot->setCurves({});
}

void BatteryDialog::run()
{
    if (m_running || m_arming.isMoving())
        return;
    BatteryOffer now = m_offer();
    if (now.whyNot.isEmpty() && !m_arming.isArmed(now.device))
        return;
    m_isRefused = now.whyNot.isEmpty() && !isAlike(now, m_now);
    take(std::move(now));
    if (m_isRefused || !m_now.whyNot.isEmpty())
        return;
    m_running = true;
    next();
}

void BatteryDialog::next()
{
    const std::size_t done = m_trials.size();
    say(tr("Step %1 of %2: to %3 %4. STOP ends it.")
            .arg(done + 1)
            .arg(m_now.battery.steps.size())
            .arg(formatSignificant(m_now.battery.steps[done].to, 4), m_now.unit));
    follow();
    m_arming.runTrial(m_now.battery.steps[done], {},
        guarded(this, [this, number = m_arming.armingNumber()](const auto &trial) { ended(trial, number); }));
}

void BatteryDialog::ended(const Result<tuning::Trial> &trial, std::uint64_t armingNumber)
{
    if (trial) {
        m_trials.push_back(*trial);
        addRow(*trial);
        showCurves();
    }
    const bool good = trial && trial->mayGoOn();
    const bool whole = m_trials.size() == m_now.battery.steps.size();
    if (good && !whole && isVisible() && m_arming.isArmed(m_now.device) && m_arming.armingNumber() == armingNumber)
        return next();
    m_running = false;
    if (!trial)
        say(tr("Ended: %1").arg(errorText(trial.error())));
    else if (trial->reason != tuning::EndReason::Done)
        say(tr("Ended by: %1").arg(guardText(trial->reason)));
    else if (!trial->stopped)
        say(tr("Ended: %1").arg(messageText(mb::say("the motor was not seen to stand"))));
    else if (!good)
        say(tr("Ended: %1").arg(messageText(mb::say("the gains were not put back: %1", trial->notPutBack))));
    else
        say(whole ? tr("Done: %1 trials in the notebook.").arg(m_trials.size())
                  : tr("Ended before all steps were run."));
    showWorst();
    follow();
}

void BatteryDialog::addRow(const tuning::Trial &trial)
{
    const int row = m_table->rowCount();
    m_table->insertRow(row);
    const auto put = [this, row](int column, const QString &text) {
        auto *item = new QTableWidgetItem(text);
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_table->setItem(row, column, item);
    };
    put(0, formatSignificant(sizeOf(trial), 4));
    for (std::size_t i = 0; i < columns.size(); ++i)
        put(static_cast<int>(i) + 1, cellText(columns[i], tuning::metricOf(trial.metrics, columns[i])));
    m_table->scrollToBottom();
}

/// The last row, and the cells that it comes from in bold.
void BatteryDialog::showWorst()
{
    if (m_trials.empty())
        return;
    const tuning::BatteryWorst worst = tuning::worstOf(m_trials);
    const int row = m_table->rowCount();
    m_table->insertRow(row);
    m_table->setItem(row, 0, new QTableWidgetItem(tr("worst")));
    for (std::size_t i = 0; i < columns.size(); ++i) {
        auto *item = new QTableWidgetItem(cellText(columns[i], tuning::metricOf(worst.metrics, columns[i])));
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_table->setItem(row, static_cast<int>(i) + 1, item);
        for (std::size_t key = 0; key < tuning::metricKeys().size(); ++key) {
            if (tuning::metricKeys()[key].key == columns[i] && worst.where[key])
                markBold(static_cast<int>(*worst.where[key]), static_cast<int>(i) + 1);
        }
    }
    for (int column = 0; column < m_table->columnCount(); ++column)
        markBold(row, column);
    m_table->scrollToBottom();
}

void BatteryDialog::markBold(int row, int column)
{
    QTableWidgetItem *const item = m_table->item(row, column);
    QFont font = item->font();
    font.setBold(true);
    item->setFont(font);
}

/// Each as a share of its own step; forwards solid, backwards dashed.
void BatteryDialog::showCurves()
{
    std::vector<Curve> curves;
    for (const tuning::Trial &trial : m_trials) {
        Curve curve;
        curve.name = formatSignificant(sizeOf(trial), 3);
        curve.look.role = trial.mode == Mode::Velocity ? TraceRole::Velocity : TraceRole::Position;
        curve.look.dash = sizeOf(trial) > 0.0 ? TraceDash::Solid : TraceDash::Long;
        double hold = 0.0;
        for (const tuning::Span &span : trial.holds)
            hold = std::max(hold, span.to - span.from);
        const tuning::Trace trace = trial.folded(tuning::measuredOf(trial.mode)).part(-1.0, hold);
        for (std::size_t i = 0; i < trace.size(); ++i) {
            curve.x.append(trace.t[i]);
            curve.y.append((trace.y[i] - trial.stimulus.from) / sizeOf(trial));
        }
        curves.push_back(std::move(curve));
    }
    m_plot->setWatermark(!m_trials.empty() && m_trials.front().simulated ? tr("DEMO") : QString());
    m_plot->setCurves(curves);
    m_plot->fit();
}

void BatteryDialog::follow()
{
    const bool armed = m_arming.isArmed(m_arming.device()); // run() asks which device it is about
    m_start->setEnabled(!m_running && armed && !m_arming.isMoving());
    m_start->setToolTip(armed ? QString() : tr("Arm the device first: hold the Arm button for 1 s."));
}

void BatteryDialog::say(const QString &words)
{
    m_words->setText(words);
    setAccessibleDescription(words);
}

QString BatteryDialog::words() const
{
    return m_words->text();
}

} // namespace mb
