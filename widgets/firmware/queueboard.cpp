// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/queueboard.h"

#include "model/family.h"
#include "widgets/common/banner.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/guarded.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/turningsplitter.h"
#include "widgets/firmware/queuebar.h"
#include "widgets/firmware/queuechecks.h"
#include "widgets/firmware/queuehead.h"
#include "widgets/firmware/queuemodel.h"
#include "widgets/firmware/queueside.h"
#include "widgets/firmware/queuetable.h"
#include "widgets/firmware/unitsteps.h"
#include "widgets/firmware/updatelog.h"
#include "widgets/service/recipeeditor.h"
#include "widgets/service/recipetext.h"
#include "widgets/service/verdictof.h"

#include <QSplitter>

#include <algorithm>

namespace mb {
namespace {

constexpr int boardBesideFrom = 640; ///< units

std::vector<std::string> linksOf(const Snapshot &shot, const Family *family, const std::vector<DeviceId> &chosen)
{
    std::vector<std::string> links;
    for (const DeviceView &device : shot.devices) {
        const bool wanted = device.family == family && std::ranges::find(chosen, device.id) != chosen.end();
        if (wanted && std::ranges::find(links, device.link) == links.end())
            links.push_back(device.link);
    }
    return links;
}

/// On which its units may be, also those that do not answer: real ones, or simulated ones.
std::vector<std::string> openLinks(const Snapshot &shot, const Family &family, bool simulated)
{
    std::vector<std::string> links;
    for (const LinkView &link : shot.links) {
        const bool fits = std::ranges::find(family.links, link.kind) != family.links.end();
        if (fits && link.state == LinkState::Open && !link.replay && link.simulated == simulated)
            links.push_back(link.address);
    }
    return links;
}

} // namespace

QueueBoard::QueueBoard(Workbench &workbench, Selection &selection, std::span<const Family *const> families,
    const ThemeSource &theme, QWidget *parent)
    : LeastHeight(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_families(families)
    , m_theme(theme)
{
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    column->addWidget(m_head = new QueueHead(theme, this));
    column->addWidget(separatorLine(Qt::Horizontal, this));
    column->addWidget(m_checks = new QueueChecks(theme, this));
    column->addWidget(m_banner = new Banner(theme, BannerKind::Caution, {}, {}, this));
    buildBody();
    buildFoot();
    connectAll();
    m_banner->setAction(tr("Go on with it"));
    m_banner->hide();
    m_head->show(m_recipe);
}

/// Where little is in sight at once, what starts the queue comes before what it starts with.
void QueueBoard::placeOrders(bool first)
{
    auto *column = static_cast<QVBoxLayout *>(layout());
    if ((column->indexOf(m_orders) == 0) == first)
        return;
    column->removeWidget(m_orders);
    column->insertWidget(first ? 0 : column->indexOf(m_banner) + 1, m_orders);
    m_side->placeSafety(first ? static_cast<QVBoxLayout *>(m_orders->layout()) : nullptr);
}

void QueueBoard::buildBody()
{
    m_orders = new QWidget(this);
    auto *orders = layoutIn<QVBoxLayout>(m_orders, 0);
    orders->addWidget(m_bar = new QueueBar(m_theme, m_orders));
    orders->addWidget(separatorLine(Qt::Horizontal, m_orders));
    layout()->addWidget(m_orders);
    connect(m_bar, &TurningRow::arranged, this, &QueueBoard::placeOrders);
    auto *split = new TurningSplitter(m_theme, boardBesideFrom, this);
    auto *left = new QSplitter(Qt::Vertical, split);
    left->addWidget(m_table = new QueueTable(m_theme, left));
    left->addWidget(m_log = new UpdateLog(m_workbench, m_theme, left));
    left->setStretchFactor(0, 3);
    left->setStretchFactor(1, 1);
    split->addWidget(left);
    split->addWidget(m_side = new QueueSide(m_theme, split));
    split->setStretchFactor(0, 1);
    split->setSizes({m_theme.theme().u(800), m_theme.theme().u(290)});
    static_cast<QVBoxLayout *>(layout())->addWidget(split, 1);
}

QueueModel &QueueBoard::model() const
{
    return m_table->model();
}

QTableView &QueueBoard::table() const
{
    return m_table->view();
}

UnitSteps &QueueBoard::steps() const
{
    return m_side->unit();
}

void QueueBoard::buildFoot()
{
    const Theme &theme = m_theme.theme();
    m_foot = new ElidedLabel({}, this);
    setTextRole(*m_foot, TextRole::Caption);
    setTone(*m_foot, Tone::Dim);
    auto *row = new QHBoxLayout;
    row->setContentsMargins(theme.u(16), theme.u(4), theme.u(16), theme.u(4));
    row->addWidget(m_foot);
    static_cast<QVBoxLayout *>(layout())->addLayout(row);
}

void QueueBoard::connectAll()
{
    const auto tryAgain = [this](auto order) {
        const auto &by = m_workbench.service().matter;
        if (by && m_shown.matter() && by->hash != m_shown.matter()->hash)
            return m_workbench.report(Severity::Caution, {},
                tr("not tried again: it was served by %1; tick it and start").arg(recipeName(by.get())));
        m_workbench.send(std::move(order), guarded(this, [this](const Result<void> &result) {
            if (!result)
                m_workbench.report(Severity::Caution, {}, tr("not tried again: %1").arg(errorText(result.error())));
        }));
    };
    connect(m_head, &QueueHead::imageChosen, this, &QueueBoard::openImage);
    connect(m_head, &QueueHead::recipeChosen, this, &QueueBoard::openRecipe);
    connect(m_head, &QueueHead::editWanted, this, &QueueBoard::edit);
    connect(m_banner, &Banner::actionTriggered, this, &QueueBoard::goOn);
    connect(m_banner, &Banner::dismissed, this, [this] {
        m_dismissed = m_cut.run;
        follow();
    });
    connect(m_bar, &QueueBar::startWanted, this, &QueueBoard::start);
    connect(m_bar, &QueueBar::pauseWanted, this, [this](bool on) { m_workbench.send(orders::PauseService{on}); });
    connect(m_bar, &QueueBar::cancelWanted, this, [this] { m_workbench.send(orders::CancelService{}); });
    connect(m_bar, &QueueBar::retryWanted, this, [tryAgain] { tryAgain(orders::RetryFailedUnits{}); });
    connect(m_bar, &QueueBar::exportWanted, this, &QueueBoard::askSave);
    connect(
        &steps(), &UnitSteps::skipWanted, this, [this](std::uint32_t row) { m_workbench.send(orders::SkipUnit{row}); });
    connect(
        &steps(), &UnitSteps::againWanted, this, [tryAgain](std::uint32_t row) { tryAgain(orders::RetryUnit{row}); });
    connect(&model(), &QueueModel::tickedChanged, this, &QueueBoard::follow);
    connect(m_table, &QueueTable::chosenChanged, this, &QueueBoard::followUnit);
    connect(&m_workbench, &Workbench::changed, this, &QueueBoard::follow);
    connect(&m_selection, &Selection::changed, this, &QueueBoard::follow);
    connect(&m_workbench, &Workbench::serviceChanged, this, [this] {
        if (m_workbench.service().running) {
            m_cut = {}; // nor is it known what will be, before it has ended
            return follow();
        }
        lookForCut();
        follow();
    });
    connect(&m_theme, &ThemeSource::changed, this, [this] {
        m_told.clear(); // the lines of the log have colours of their own
        m_log->clear();
        follow();
    });
}

bool QueueBoard::openImage(const QString &path)
{
    std::vector<const Family *> families;
    const auto add = [&families](const Family *family) {
        if (std::ranges::find(families, family) == families.end())
            families.push_back(family);
    };
    if (const DeviceView *device = m_workbench.snapshot().device(m_selection.device()))
        add(device->family);
    for (const DeviceView &device : m_workbench.snapshot().devices)
        add(device.family);
    return opened(m_recipe.openImage(path, families));
}

void QueueBoard::edit()
{
    if (auto *open = findChild<RecipeEditor *>(); open && open->isVisible()) {
        open->raise();
        open->activateWindow();
        return;
    }
    auto *editor = new RecipeEditor(m_families, m_recipeFolder, m_theme, this);
    editor->setAttribute(Qt::WA_DeleteOnClose);
    if (const auto read = m_recipe.path().isEmpty() ? Result<void>() : editor->openFile(m_recipe.path()); !read)
        m_workbench.report(Severity::Danger, {}, errorText(read.error()));
    connect(editor, &RecipeEditor::saved, this, &QueueBoard::openRecipe);
    editor->show();
}

bool QueueBoard::opened(const Result<void> &result)
{
    if (!result) {
        m_workbench.report(Severity::Danger, {}, errorText(result.error()));
        return false;
    }
    if (m_workbench.service().running)
        m_workbench.report(
            Severity::Info, {}, tr("%1 waits until this queue has ended").arg(recipeName(m_recipe.matter().get())));
    else
        lookForCut();
    follow();
    return true;
}

/// Whether the journal has a run of this recipe that nobody has brought to its end.
void QueueBoard::lookForCut()
{
    if (!m_recipe.matter())
        return;
    m_workbench.visits().findCut(*m_recipe.matter(), guarded(this, [this](const Result<CutRun> &cut) {
        m_cut = cut ? *cut : CutRun{};
        follow();
    }));
}

/// Why nothing can be started, in words; empty when it can.
QString QueueBoard::hindrance() const
{
    if (m_workbench.service().running)
        return tr("A queue runs already.");
    if (!m_recipe.matter())
        return tr("Open an image or a recipe first.");
    if (model().ticked().empty())
        return tr("Tick the units first.");
    return {};
}

void QueueBoard::start()
{
    if (canStart())
        begin(model().ticked(), {});
}

bool QueueBoard::mayGoOn() const
{
    if (m_cut.run.empty() || m_workbench.service().running)
        return false;
    return !m_cut.simulated || !openLinks(m_workbench.snapshot(), *m_recipe.family(), true).empty();
}

void QueueBoard::goOn()
{
    if (mayGoOn())
        begin(model().ticked(), m_cut.run);
}

void QueueBoard::begin(std::vector<DeviceId> chosen, const std::string &run)
{
    m_told.clear();
    m_log->clear();
    const Snapshot &shot = m_workbench.snapshot();
    std::vector<std::string> links
        = run.empty() ? linksOf(shot, m_recipe.family(), chosen) : openLinks(shot, *m_recipe.family(), m_cut.simulated);
    m_workbench.send(orders::ServeUnits{m_recipe.matter(), std::move(links), std::nullopt, std::move(chosen), run},
        guarded(this, [this](const Result<void> &result) {
            if (!result)
                m_workbench.report(Severity::Danger, {}, errorText(result.error()));
        }));
}

void QueueBoard::askSave()
{
    askWhereToSave(*this, tr("Save what was done"), tr("Table (*.csv)"), QStringLiteral("queue.csv"),
        [this](const QString &path) { save(path); });
}

void QueueBoard::save(const QString &path)
{
    std::vector<service::Visit> visits;
    for (const service::QueueRow &row : m_workbench.service().rows) {
        if (!row.visit.id.empty())
            visits.push_back(row.visit);
    }
    m_workbench.visits().exportTo(path, std::move(visits), guarded(this, [this, path](const Result<void> &result) {
        m_workbench.report(result ? Severity::Good : Severity::Danger, {},
            result ? tr("the units are in %1").arg(path) : errorText(result.error()));
    }));
}

void QueueBoard::showEvent(QShowEvent *event)
{
    LeastHeight::showEvent(event);
    follow();
}

void QueueBoard::follow()
{
    if (!isVisible())
        return;
    const ServiceView &view = m_workbench.service();
    const Instant now = m_workbench.now();
    followRecipe();
    const std::string version = m_shown.matter() ? m_shown.matter()->imageVersion : std::string();
    model().setChoosing(!view.running);
    model().setLines(queueLines(view, m_workbench.snapshot(), m_shown.family(), version, now));
    m_table->followTicks(view.running);
    m_head->setChoosing(!view.running);
    m_bar->follow(view, totalsOf(view, now), hindrance());
    if (!m_cut.run.empty())
        m_banner->setText(
            tr("The last queue of this recipe was cut off: %1 done, %2 open").arg(m_cut.ended).arg(m_cut.open),
            tr("What has ended stays as it is; ticked units are taken along."));
    m_banner->setVisible(mayGoOn() && m_cut.run != m_dismissed);
    m_foot->setText(
        view.running ? tr(
            "One unit at a time on a bus, buses side by side. Real units keep this computer awake. The journal is on "
            "disk: after a crash the queue goes on.")
                     : tr("Every unit is backed up before and compared afterwards; the journal has it."));
    m_checks->follow(m_workbench.snapshot(), model().ticked(), m_shown.matter() != nullptr, now);
    followLog();
    followUnit();
}

/// Production may have begun a queue with another.
void QueueBoard::followRecipe()
{
    const ServiceView &view = m_workbench.service();
    const QueueRecipe recipe = view.running && view.matter ? QueueRecipe(view.matter) : m_recipe;
    if (recipe.matter() == m_shown.matter())
        return;
    m_shown = recipe;
    m_head->show(m_shown);
    m_side->noteWhatTurns(m_shown);
    m_table->setKind(m_shown.family() ? tableText(m_shown.family()->title) : QString());
}

/// What was said since, of all units in the order of time.
void QueueBoard::followLog()
{
    struct Said {
        LogLine line;
        QString who;
    };
    std::vector<Said> news;
    for (const service::QueueRow &row : m_workbench.service().rows) {
        std::size_t &told = m_told[row.id];
        const std::size_t count = row.log ? row.log->size() : 0;
        for (; told < count; ++told)
            news.push_back({(*row.log)[told], nameOf(row)});
    }
    std::ranges::stable_sort(news, [](const Said &a, const Said &b) { return a.line.time < b.line.time; });
    for (const Said &said : news)
        m_log->add(said.line, said.who);
}

/// The one that is selected, else the one that runs, else, where no other line is selected, the one that was served last.
const service::QueueRow *QueueBoard::shownRow() const
{
    using service::QueueRow;
    using service::RowState;
    const QueueLine *chosen = m_table->chosen();
    const QueueRow *running = nullptr;
    const QueueRow *last = nullptr;
    for (const QueueRow &row : m_workbench.service().rows) {
        if (model().rowOf(row.id) < 0)
            continue; // not listed yet
        if (chosen && chosen->row == row.id)
            return &row;
        if (row.state == RowState::Running && !running)
            running = &row;
        if (!last || row.startedAt > last->startedAt)
            last = &row;
    }
    return running || chosen ? running : last;
}

/// A unit that was served is shown by what it was served by, whatever is open for the next queue.
void QueueBoard::followUnit()
{
    const service::QueueRow *row = shownRow();
    const auto &by = m_workbench.service().matter;
    const QueueLine *line
        = row ? &model().lines().at(static_cast<std::size_t>(model().rowOf(row->id))) : m_table->chosen();
    m_side->showUnit(row, line, row && by ? QueueRecipe(by) : m_shown);
}

} // namespace mb
