// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/expression.h"

#include "recording/movingvalue.h"

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace mb {
namespace {

constexpr std::size_t longestText = 4000;
constexpr std::size_t deepest = 32;
constexpr double longestAverage = 3600.0;
constexpr std::array functions{std::pair{std::string_view("derivative"), MovingValue::Kind::Derivative},
    std::pair{std::string_view("integral"), MovingValue::Kind::Integral},
    std::pair{std::string_view("average"), MovingValue::Kind::Average}};

bool isWord(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// A single = that is no part of ==, <=, >= or !=.
bool assigns(std::string_view text)
{
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '=')
            continue;
        if (i + 1 < text.size() && text[i + 1] == '=')
            ++i;
        else if (i == 0 || std::string_view("<>!").find(text[i - 1]) == std::string_view::npos)
            return true;
    }
    return false;
}

/// muParser throws; it ends here.
Result<void> guarded(const auto &work)
{
    try {
        work();
        return {};
    } catch (const mu::Parser::exception_type &error) {
        return fail(Fault::OutOfRange, Message::verbatim(error.GetMsg()));
    }
}

} // namespace

/// A tree as a list: each step takes values of the signals and of the steps before it.
struct Expression::Formula {
    struct Step {
        mu::Parser parser;
        MovingValue moving;
    };
    std::vector<std::size_t> used;
    std::vector<double> values;                ///< one for each name
    std::vector<std::unique_ptr<double>> kept; ///< results of the steps; addresses are bound
    std::vector<std::unique_ptr<Step>> steps;
    mu::Parser whole;
};

struct Expression::Compiler {
    Formula &formula;
    const std::vector<std::string> &names;
    std::size_t depth = 0;

    Result<void> bind(mu::Parser &parser, const std::string &text)
    {
        return guarded([&] {
            for (std::size_t i = 0; i < names.size(); ++i)
                parser.DefineVar(names[i], &formula.values[i]);
            for (std::size_t i = 0; i < formula.kept.size(); ++i)
                parser.DefineVar("step__" + std::to_string(i), formula.kept[i].get());
            parser.SetExpr(text);
            (void)parser.Eval(); // says now what is wrong with it
            const auto found = parser.GetUsedVar();
            for (std::size_t i = 0; i < names.size(); ++i) {
                if (found.count(names[i]) > 0)
                    formula.used.push_back(i);
            }
        });
    }

    /// Replaces the calls of our functions in `text` by what holds their results.
    Result<std::string> compile(std::string text)
    {
        if (++depth > deepest)
            return fail(Fault::OutOfRange, say("the formula is nested too deeply"));
        for (std::size_t at = 0; at < text.size(); ++at) {
            if (!std::isalpha(static_cast<unsigned char>(text[at])) || (at > 0 && isWord(text[at - 1])))
                continue;
            for (const auto &[name, kind] : functions) {
                if (text.compare(at, name.size(), name) != 0)
                    continue;
                const std::size_t open = text.find_first_not_of(' ', at + name.size());
                if (open == std::string::npos || text[open] != '(')
                    continue;
                auto replaced = call(text, at, open, kind);
                if (!replaced)
                    return replaced;
                text = std::move(*replaced);
                break;
            }
        }
        --depth;
        return text;
    }

    struct Brackets {
        std::size_t open;
        std::size_t close; ///< the size of the text: missing
        std::size_t comma; ///< of this level; npos: none; the size of the text: several
    };

    static Brackets bracketsAt(const std::string &text, std::size_t open)
    {
        Brackets found{open, open, std::string::npos};
        int level = 0;
        for (; found.close < text.size(); ++found.close) {
            const char c = text[found.close];
            level += c == '(' ? 1 : c == ')' ? -1 : 0;
            if (level == 1 && c == ',')
                found.comma = found.comma == std::string::npos ? found.close : text.size();
            if (level == 0)
                break;
        }
        return found;
    }

    static Result<double> secondsFrom(const std::string &number)
    {
        double seconds = 0.0;
        const Result<void> read = guarded([&] {
            mu::Parser parser;
            parser.SetExpr(number);
            seconds = parser.Eval();
        });
        if (!read || !(seconds > 0.0 && seconds <= longestAverage))
            return fail(Fault::OutOfRange, say("average takes 0 to 3600 seconds, not '%1'", number));
        return seconds;
    }

    Result<std::string> call(const std::string &text, std::size_t at, std::size_t open, MovingValue::Kind kind)
    {
        const auto [first, close, comma] = bracketsAt(text, open);
        if (close == text.size())
            return fail(Fault::OutOfRange, say("a parenthesis is not closed"));
        const bool average = kind == MovingValue::Kind::Average;
        if (average != (comma < close))
            return fail(Fault::OutOfRange,
                average ? say("average takes a signal and seconds, such as average(x, 0.1)")
                        : say("derivative and integral take one signal"));
        MB_TRY(
            const auto seconds, average ? secondsFrom(text.substr(comma + 1, close - comma - 1)) : Result<double>(0.0));
        auto inner = compile(text.substr(first + 1, std::min(comma, close) - first - 1));
        if (!inner)
            return inner;
        auto step = std::make_unique<Formula::Step>(Formula::Step{{}, MovingValue(kind, seconds)});
        MB_TRY_VOID(bind(step->parser, *inner));
        formula.steps.push_back(std::move(step));
        formula.kept.push_back(std::make_unique<double>(1.0));
        return text.substr(0, at) + "step__" + std::to_string(formula.kept.size() - 1) + text.substr(close + 1);
    }
};

Expression::Expression(std::unique_ptr<Formula> formula)
    : m_formula(std::move(formula))
{
}

Expression::Expression(Expression &&other) noexcept = default;
Expression &Expression::operator=(Expression &&other) noexcept = default;
Expression::~Expression() = default;

Result<Expression> Expression::parse(std::string_view text, const std::vector<std::string> &names)
{
    if (text.size() > longestText)
        return fail(Fault::OutOfRange, say("a formula has at most 4000 characters"));
    if (text.find("step__") != std::string_view::npos || assigns(text))
        return fail(Fault::OutOfRange, say("a formula assigns nothing"), say("write == to compare"));
    auto formula = std::make_unique<Formula>();
    formula->values.assign(names.size(), 1.0);
    Compiler compiler{*formula, names};
    MB_TRY(const auto rest, compiler.compile(std::string(text)));
    MB_TRY_VOID(compiler.bind(formula->whole, rest));
    std::ranges::sort(formula->used);
    formula->used.erase(std::unique(formula->used.begin(), formula->used.end()), formula->used.end());
    if (formula->used.empty())
        return fail(Fault::OutOfRange, say("the formula uses no signal"));
    return Expression(std::move(formula));
}

const std::vector<std::size_t> &Expression::used() const
{
    return m_formula->used;
}

double Expression::evaluate(double seconds, std::span<const double> values)
{
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < m_formula->used.size(); ++i) {
        if (std::isnan(values[i])) {
            restart();
            return nothing;
        }
        m_formula->values[m_formula->used[i]] = values[i];
    }
    double result = nothing;
    const Result<void> evaluated = guarded([&] {
        for (std::size_t i = 0; i < m_formula->steps.size(); ++i) {
            Formula::Step &step = *m_formula->steps[i];
            *m_formula->kept[i] = step.moving.feed(seconds, step.parser.Eval());
        }
        result = m_formula->whole.Eval();
    });
    return evaluated && std::isfinite(result) ? result : nothing;
}

void Expression::restart()
{
    for (const auto &step : m_formula->steps)
        step->moving.restart();
}

} // namespace mb
