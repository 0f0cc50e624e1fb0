#include <sstream>

#include "experiments/cli/usage.h"

namespace subdiv::cli {
namespace {

/// Text as a line of mdoc: no escapes, no macro by accident.
std::string line_of(const std::string& text) {
  std::string result = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) result += c == '\\' ? std::string("\\e") : std::string(1, c);
  return result + "\n";
}

/// An argument of a macro.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') {
      result += "\\(dq";
    } else {
      result += c == '\\' ? std::string("\\e") : std::string(1, c);
    }
  }
  return result + "\"";
}

/// "Fl -out Ar DIR": a name without its first dash, which Fl writes.
std::string flag(const std::string& name, const OptionUsage& option) {
  const std::string shown = "Fl " + name.substr(1);
  return option.value.empty() ? shown : shown + " Ar " + quoted(option.value);
}

std::string synopsis(const VerbUsage& verb) {
  std::string text = ".Nm\n.Cm " + verb.name + "\n";
  for (const OptionUsage& option : verb.options) {
    if (option.names.front() == "--help") continue;
    text += std::string(option.required ? "." : ".Op ") + flag(option.names.front(), option) + "\n";
  }
  for (const OptionUsage& word : verb.words)
    text += std::string(word.required ? "." : ".Op ") + "Ar " + quoted(word.value) +
            (word.repeated ? " ..." : "") + "\n";
  return text;
}

/// Text with a full stop, in lines of the length that manuals have.
std::string sentence(const std::string& text) {
  constexpr std::size_t width = 78;
  std::istringstream words(text.ends_with('.') ? text : text + ".");
  std::string result;
  std::string line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > width) {
      result += line_of(line);
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return result + line_of(line);
}

/// One entry of a list of options or words.
std::string entry(const OptionUsage& option) {
  std::string text = ".It ";
  if (option.names.empty()) {
    text += "Ar " + quoted(option.value);
  } else {
    for (std::size_t i = 0; i < option.names.size(); ++i)
      text += (i > 0 ? " , " : "") + flag(option.names[i], option);
  }
  text += "\n" + sentence(option.meaning);
  if (!option.choices.empty()) {
    std::string choices;
    for (const std::string& choice : option.choices) choices += (choices.empty() ? "" : ", ") + choice;
    text += sentence("One of: " + choices);
  }
  if (!option.limits.empty()) text += sentence("Values: " + option.limits);
  if (!option.default_value.empty()) text += sentence("Default: " + option.default_value);
  if (option.required) text += "Required.\n";
  return text;
}

std::string section_of(const VerbUsage& verb) {
  std::string text = ".Ss " + verb.name + "\n" + synopsis(verb) + ".Pp\n" + sentence(verb.summary);
  for (const std::string& note : verb.notes) text += sentence(note);
  const std::string list = ".Bl -tag -width Ds\n";
  text += list;
  for (const OptionUsage& word : verb.words) text += entry(word);
  for (const OptionUsage& option : verb.options) {
    if (option.names.front() != "--help") text += entry(option);
  }
  if (text.ends_with(list)) {
    text.erase(text.size() - list.size());
  } else {
    text += ".El\n";
  }
  if (verb.examples.empty()) return text;
  text += ".Bd -literal -offset indent\n";
  for (const std::string& example : verb.examples) text += line_of(example);
  return text + ".Ed\n";
}

constexpr const char* head =
    R"(.\" Made by 'subdivlab manual': change experiments/cli/manual.cpp or command_line.cpp instead.
.Dd November 22, 2026
.Dt SUBDIVLAB 1
.Os
.Sh NAME
.Nm subdivlab
.Nd analyses and optimises subdivision schemes, with proofs
.Sh SYNOPSIS
)";

constexpr const char* description = R"(.Nm
.Fl -help | Fl h
.Nm
.Fl -version
.Sh DESCRIPTION
Subdivision schemes turn a coarse polygon, grid or mesh into a smooth curve or
surface by local averages.
.Nm
answers questions about a scheme (smoothness, limit and area masks,
reproduction of polynomials, eigenvalues),
looks for the parameters that are best for an objective, draws what a scheme
makes of given points,
and regenerates the claims of the papers on J-splines, polyloops and surface
rings of adjustable speed.
.Pp
What it says is exact, certified or approximate, and it says which (see
.Sx VERDICTS ) .
A computation that its budget ends is undecided, never false.
.Pp
Verbs are described in
.Sx VERBS ,
the notation of schemes in
.Sx SCHEMES .
Options and words of a verb may stand in any order;
.Fl -
ends the options,
.Fl -help
prints those of a verb, with examples.
.Sh VERBS
)";

constexpr const char* tail = R"(.Sh SCHEMES
.Ar SCHEME
is a named family or a scheme file, with values for its parameters behind a
colon:
.Bd -literal -offset indent
SCHEME = STEP { + STEP }
STEP   = (NAME | FILE.json) [ : parameter = value { , parameter = value } ]
.Ed
.Pp
Steps joined by + are those of a mixed scheme; the last of them repeats for
ever.
.Ql jspline:s=-33/26+jspline:s=3/2
takes one step of J_s with s = -33/26 and all others with s = 3/2.
.Pp
Values are exact: integers, quotients p/q, decimals (taken as the number that
they show), sqrt(..),
and expressions of these with + - * / ^ and parentheses; a sum in a value
stands in parentheses.
A name in the place of a value leaves the parameter free:
.Ql four-point:w=w
is answered for all w at once,
.Ql jspline:s=r+jspline:s=3/2
has the free parameter r, for which
.Fl -over
gives a range.
.Pp
.Ql subdivlab list schemes
lists the families with their parameters, ranges and sources.
Those for meshes stand on their own, without +.
.Ss Scheme files
A scheme file is a JSON object with the members
.Bl -tag -width parameters
.It Cm name
The name, in quotes.
.It Cm arity
2 or 3: how many new points a step makes for each old one.
.It Cm parameters
May be left out: names with default values, such as { "w": "1/16" }.
.It Cm mask
{ "first": I, "coefficients": [..] }: coefficient k of the list, from 0, takes
control point j to the refined point
I + k + arity j.
.It Cm symbol
In place of
.Cm mask :
an expression in z and the parameters, such as "2*((1+z)/2)^4".
.It Cm source
May be left out: where the scheme comes from.
.El
.Pp
Numbers are as above; JSON numbers count as the decimals that they show.
The coefficients must add up to the arity.
The schema scheme.schema.json, beside this manual in the sources and in
share/subdivlab/schemas when installed,
says the same for editors.
Others describe the answers of
.Cm analyze , certify , optimize
and
.Cm eigen
with
.Fl -json .
.Ss Objectives
.Ar NAME Ns Op : Ns Ar option Ns = Ns Ar value Ns Op ,...
names what
.Cm optimize
minimises:
.Ql subdivlab list objectives
lists them with their options and norms.
.Ss Operators on polygons
.Cm smooth
takes a sequence of operators parted by semicolons:
.Cm refine ,
.Cm split ,
.Cm dual ,
.Cm tuck Ns Pq t ,
.Cm untuck ,
.Cm tweak Ns Pq a, b ,
.Cm J Ns Pq s ;
.Ql {..}^N
repeats what stands in braces.
.Sh VERDICTS
.Bl -tag -width not-reproducible
.It Cm reproduced
What the document prints holds, proved.
.It Cm refuted
It does not; the note says what is true.
.It Cm established
A finding of the project's own, proved.
.It Cm undecided
The budget ended; the enclosure that was reached is shown.
.It Cm consistent , Cm inconsistent
All that an approximate value may say.
.It Cm not-reproducible
A figure or formula is lost; the note says which.
.El
.Pp
The rigour of a value is
.Cm exact
(decided in exact arithmetic),
.Cm certified
(proved to lie in an enclosure, in exact or outward-rounded arithmetic), or
.Cm approximate .
.Sh ENVIRONMENT
.Bl -tag -width SUBDIVLAB_DATA
.It Ev SUBDIVLAB_DATA
The folder of the polygons and meshes that experiments read,
in place of the one that is installed with the program.
.It Ev PATH
Where gnuplot is looked for, which draws the figures of
.Cm reproduce .
.El
.Sh FILES
.Bl -tag -width Ds
.It Pa *.csv
Points, one a line: x,y or x,y,z.
Lines that begin with # are comments.
A grid names its columns row,column,x,y,z.
.It Pa *.obj , *.off , *.ply
Meshes; the vertices of an
.Pa .obj
file serve as a polygon, too.
.It Pa *.svg
Pictures, for output alone.
.It Pa *.bv
Patches of surface rings for BezierView, for output alone.
.It Pa *.json
Scheme files, and claims of one's own for
.Cm reproduce
and
.Cm check .
.It Pa results/
What
.Cm reproduce
writes and
.Cm check
compares with: claims.json, claims.csv, series/, figures/, report/.
claims.json is described by claims.schema.json.
.It Pa results/certificates/
Proofs of exact and certified claims, for
.Cm verify .
.El
.Pp
The file name - stands for standard output where an output is asked for.
Files are written whole or not at all.
.Sh EXIT STATUS
.Bl -tag -width 1
.It 0
Done; a refuted claim is a result.
.It 1
A comparison fails, a verdict changed, or an experiment broke.
.It 2
Bad input or usage: the message on standard error says where, what is wrong
and what would be right.
.It 3
Undecided within the budget.
.El
.Sh EXAMPLES
What is known of a scheme of the four-point family, and for which w it is C^1:
.Bd -literal -offset indent
subdivlab analyze four-point:w=1/16
subdivlab certify four-point:w=w --over w=-1/4..1/4 --continuity 1
.Ed
.Pp
The first step whose limit comes nearest to the control points, before quintic
B-splines:
.Bd -literal -offset indent
subdivlab optimize jspline:s=r+jspline:s=3/2 --over r=-2..2 --objective vertex --norm linf
.Ed
.Pp
A curve from a polygon, and the Hausdorff distance between two polygons:
.Bd -literal -offset indent
subdivlab refine jspline:s=1/2 shape.csv --levels 6 --out shape.svg
subdivlab measure shape.csv --against other.csv
.Ed
.Pp
Completion of verbs, options and values in bash:
.Bd -literal -offset indent
source <(subdivlab completion bash)
.Ed
.Sh SEE ALSO
.Xr gnuplot 1
)";

}  // namespace

std::string manual_page(const std::vector<VerbUsage>& verbs) {
  std::string page = head;
  for (const VerbUsage& verb : verbs) page += synopsis(verb);
  page += description;
  for (const VerbUsage& verb : verbs) page += section_of(verb);
  return page + tail;
}

}  // namespace subdiv::cli
