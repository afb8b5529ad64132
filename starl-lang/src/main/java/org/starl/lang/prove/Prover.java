// Longer than 500 lines because each kind of claim has one method here, and all share how Z3 is
// asked.
package org.starl.lang.prove;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.IntFunction;
import java.util.stream.Stream;
import org.starl.lang.prove.Claim.Verdict;
import org.starl.lang.prove.Question.Frame;
import org.starl.lang.prove.Solver.Answer;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Function;
import org.starl.lang.tree.Refinement;

/** Proves the invariants of an automaton. */
public final class Prover {

  /** The most elements of an opaque type that are tried where any number is not decided. */
  public static final int MOST_ELEMENTS = 5;

  private final Automaton automaton;
  private final long limit;
  private final BiConsumer<String, String> keep;
  private final Map<String, List<Frame>> frames = new LinkedHashMap<>();
  private boolean seeksExamples = true;

  /**
   * @param limit steps of Z3 for each obligation
   * @param keep takes the name and the text of each script
   */
  public Prover(Automaton automaton, long limit, BiConsumer<String, String> keep) {
    this.automaton = automaton;
    this.limit = limit;
    this.keep = keep;
  }

  /** What Z3 says of one obligation. */
  private record Finding(Verdict verdict, List<String> lines, Optional<String> action) {

    static final Finding PROVED = new Finding(Verdict.PROVED, List.of());

    Finding(Verdict verdict, List<String> lines) {
      this(verdict, lines, Optional.empty());
    }

    boolean isGood() {
      return verdict == Verdict.PROVED || verdict == Verdict.PROVED_SMALL;
    }
  }

  /**
   * Proves what can be proved.
   *
   * @throws NoSolver if Z3 cannot be loaded
   * @throws Unprovable if the source has something that is not translated
   */
  public Report prove() {
    List<Claim> claims = new ArrayList<>();
    measures(automaton, claims);
    // Of parameters alone: a state has no values of a type without any.
    Automaton numbers = automaton.ofParameters(automaton.ranges());
    claims.addAll(
        undefined(
            "start",
            (size, title) -> new Question(numbers, size, title),
            question ->
                question.obligations(
                    Stream.concat(
                            numbers.assumptions().stream().map(Invariant::condition),
                            numbers.maybeEmpty().stream().map(Exprs::defined))
                        .toList())));
    List<Claim> undefined =
        undefined(
            "start",
            (size, title) -> new Question(automaton, size, title),
            question ->
                question.obligations(
                    Stream.concat(
                            automaton.assumptions().stream().map(Invariant::condition),
                            automaton.start().stream())
                        .toList()));
    undefined.stream().filter(each -> !claims.contains(each)).forEach(claims::add);
    claims.add(start());
    if (claims.stream().allMatch(Claim::isGood)) {
      claims.addAll(new Induction(automaton.invariants()).claims(Induction.worst(claims)));
    }
    automaton
        .constraints()
        .forEach(each ->
            claims.add(
                new Claim(
                    each.name(),
                    Verdict.PROVED,
                    "bounds 'starl check' alone: what is proved is so of all states",
                    List.of())));
    automaton
        .claims()
        .forEach(each ->
            claims.add(
                new Claim(
                    each,
                    Verdict.UNDECIDED,
                    "is not looked at: 'starl check' asks for progress",
                    List.of())));
    return new Report(automaton.name(), List.copyOf(claims));
  }

  // --- obligations -------------------------------------------------------------------------------

  private Answer ask(String name, int size, Question question, Asked then) {
    Script script = question.script();
    String file = name.replaceAll("[^A-Za-z0-9_.-]+", "-") + (size == 0 ? "" : "-of-" + size);
    keep.accept(file, Solver.options(limit) + script + "(check-sat)\n");
    try (Solver solver = new Solver(script, limit)) {
      Answer answer = solver.check();
      boolean isOfPoints = size == 0 && Sorts.isRecursive(automaton);
      if (answer == Answer.SAT && (isOfPoints || question.isApproximate())) {
        answer = Answer.UNKNOWN; // the values of such functions are known at some points alone
      }
      then.answered(answer, solver);
      return answer;
    }
  }

  private interface Asked {
    void answered(Answer answer, Solver solver);
  }

  /** That no state is as {@code questions} ask, for any number of elements, or for a few. */
  private Finding refute(String name, IntFunction<Question> questions) {
    return refute(name, questions.apply(0), questions);
  }

  private Finding refute(String name, Question any, IntFunction<Question> questions) {
    Answer general = ask(name, 0, any, (answer, solver) -> {});
    if (general == Answer.UNSAT) {
      return Finding.PROVED;
    }
    if (Sorts.isRecursive(automaton) && !seeksExamples) {
      return new Finding(Verdict.UNDECIDED, List.of()); // few numbers prove nothing
    }
    for (int size = 1; size <= sizes(); size++) {
      Question question = questions.apply(size);
      List<String> lines = new ArrayList<>();
      Answer answer =
          ask(
              name,
              size,
              question,
              (found, solver) -> {
                if (found == Answer.SAT) {
                  lines.addAll(question.shown(solver));
                }
              });
      if (answer != Answer.UNSAT) {
        boolean fails = answer == Answer.SAT && !Sorts.isRecursive(automaton);
        return new Finding(fails ? Verdict.FAILED : Verdict.UNDECIDED, lines);
      }
    }
    if (general == Answer.SAT) {
      return new Finding(Verdict.FAILED, List.of());
    }
    if (Sorts.isRecursive(automaton)) {
      return new Finding(Verdict.UNDECIDED, List.of());
    }
    return isOfOneSize() ? Finding.PROVED : new Finding(Verdict.PROVED_SMALL, List.of());
  }

  private int sizes() {
    return isOfOneSize() ? 1 : MOST_ELEMENTS;
  }

  private boolean isOfOneSize() {
    return automaton.typeParameters().isEmpty() && automaton.numbers().isEmpty();
  }

  /** That some state is as {@code questions} ask. */
  private Finding exists(String name, IntFunction<Question> questions) {
    for (int size = 1; size <= sizes(); size++) {
      if (ask(name, size, questions.apply(size), (answer, solver) -> {}) == Answer.SAT) {
        return Finding.PROVED;
      }
    }
    Answer any = ask(name, 0, questions.apply(0), (answer, solver) -> {});
    return switch (any) {
      case SAT -> Finding.PROVED;
      case UNSAT -> new Finding(Verdict.FAILED, List.of());
      case UNKNOWN -> new Finding(Verdict.UNDECIDED, List.of());
    };
  }

  /** The operations that may have no value where {@code at} asks, each told for itself. */
  private List<Claim> undefined(
      String subject,
      BiFunction<Integer, String, Question> at,
      java.util.function.Function<Question, List<Obligation>> obligations) {
    String title = subject + " is defined";
    Question any = at.apply(0, title);
    List<Obligation> all = obligations.apply(any);
    if (all.isEmpty()) {
      return List.of();
    }
    any.failing(all);
    if (ask(title, 0, any, (answer, solver) -> {}) == Answer.UNSAT) {
      return List.of();
    }
    List<Claim> claims = new ArrayList<>();
    int part = 0;
    for (Obligation.Place place : Obligation.places(all)) {
      part++;
      String name = title + " part " + part;
      Finding found =
          refute(
              name,
              size -> {
                Question question = at.apply(size, name);
                question.failing(place.among(obligations.apply(question)));
                return question;
              });
      if (found.verdict() == Verdict.PROVED) {
        continue;
      }
      String text = place.otherwise();
      claims.add(
          found.verdict() == Verdict.PROVED_SMALL
              ? new Claim(subject, found.verdict(), "has values " + small(), List.of())
              : new Claim(
                  subject,
                  found.verdict(),
                  found.verdict() == Verdict.FAILED ? text : "perhaps " + text + ": not decided",
                  found.lines(),
                  Optional.empty(),
                  Optional.of(place.pos())));
    }
    return claims;
  }

  /** {@code any number of PIDS and any N}. */
  private String sizes(String ofTypes, String before, String after) {
    List<String> all = new ArrayList<>();
    if (!automaton.typeParameters().isEmpty()) {
      all.add(ofTypes + String.join(" and ", automaton.typeParameters()));
    }
    automaton.numbers().forEach(name -> all.add(before + name + after));
    return String.join(" and ", all);
  }

  private String small() {
    String most = String.valueOf(MOST_ELEMENTS);
    return "for "
        + sizes("1 to " + most + " of ", "", " to " + most)
        + "; for more it is not decided";
  }

  /** Only a function that ends can be defined by itself. */
  private void measures(Automaton of, List<Claim> claims) {
    of.uses().values().forEach(used -> measures(used, claims));
    for (Function function : of.functions()) {
      if (function.measure().isPresent()) {
        String name = function.signature().name();
        String title = name + " ends";
        Question question = new Question(of, 0, title);
        boolean ends =
            !question.growing(function) || ask(title, 0, question, (a, s) -> {}) == Answer.UNSAT;
        claims.add(
            ends
                ? new Claim(name, Verdict.PROVED, "ends", List.of())
                : new Claim(
                    name,
                    Verdict.UNDECIDED,
                    "may not end: its measure may not become smaller",
                    List.of(),
                    Optional.empty(),
                    Optional.of(function.measure().get().pos())));
        claims.addAll(
            undefined(name, (n, t) -> new Question(of, n, t), at -> at.obligations(function)));
      }
    }
  }

  private Claim start() {
    String title = "a start state exists";
    Finding found = exists(title, size -> new Question(automaton, size, title).atStart());
    String text =
        switch (found.verdict()) {
          case PROVED -> "is possible" + seen();
          case FAILED -> "contradicts itself: there is no start state";
          default -> "is not decided: no start state found";
        };
    Verdict verdict = found.verdict() == Verdict.FAILED ? Verdict.UNDECIDED : found.verdict();
    return new Claim("start", verdict, text, List.of()); // of no state, all would hold
  }

  /** How far a state is known to exist. */
  private String seen() {
    return Sorts.isRecursive(automaton) ? ", seen with numbers to " + Sorts.MOST_NUMBER : "";
  }

  /** What an invariant is made of: the parts of its conjunctions, each for itself. */
  private static List<Expr> parts(Expr condition) {
    List<Expr> all = new ArrayList<>();
    switch (condition) {
      case Expr.Binary b when b.operator() == Expr.Operator.AND -> {
        all.addAll(parts(b.left()));
        all.addAll(parts(b.right()));
      }
      case Expr.Binary b when b.operator() == Expr.Operator.IMPLIES ->
          parts(b.right())
              .forEach(p -> all.add(new Expr.Binary(b.operator(), b.left(), p, b.type(), b.pos())));
      case Expr.Quantified q when q.forAll() ->
          parts(q.body())
              .forEach(p -> all.add(new Expr.Quantified(true, q.variables(), p, q.pos())));
      default -> all.add(condition);
    }
    return all;
  }

  private Question step(int size, Action action, List<Invariant> assumed, String title) {
    return new Question(automaton, size, title).assuming(assumed).happens(action);
  }

  /** Frames of recursive functions that hold after an action. */
  private List<Frame> frames(Action action) {
    List<Frame> known = frames.get(action.name());
    if (known == null) {
      known = new ArrayList<>();
      for (Frame frame : Question.frames(automaton, action)) {
        String title =
            action.name() + " keeps " + frame.function().signature().name() + " " + frame.most();
        Question question = new Question(automaton, 0, title.strip()).happens(action);
        question.failing(frame);
        if (ask(title.strip(), 0, question, (a, s) -> {}) == Answer.UNSAT) {
          known.add(frame);
          break; // those that follow say less
        }
      }
      frames.put(action.name(), known);
    }
    return known;
  }

  // --- mutual induction --------------------------------------------------------------------------

  /** Which invariants are kept if all of them hold before, and which of these without the others. */
  private final class Induction {

    private final List<Invariant> all;
    private final Map<String, Claim> claims = new LinkedHashMap<>();

    Induction(List<Invariant> all) {
      this.all = all;
    }

    /** @param before how far operations have values that all rest on */
    List<Claim> claims(Verdict before) {
      List<Invariant> kept = new ArrayList<>(all);
      Map<String, Finding> findings = round(all, true);
      List<String> failed = new ArrayList<>();
      seeksExamples = false;
      while (drop(kept, findings, failed)) {
        findings = round(kept, false);
      }
      seeksExamples = true;
      List<Invariant> general = general(kept, findings);
      List<Claim> undefined = undefinedWith(general);
      Verdict most = worst(before, worst(undefined));
      if (most.compareTo(Verdict.PROVED_SMALL) > 0 && general.size() < kept.size()) {
        undefined = undefinedWith(kept);
        most = worst(Verdict.PROVED_SMALL, worst(undefined));
      }
      for (Invariant each : kept) {
        Verdict verdict = general.contains(each) ? Verdict.PROVED : Verdict.PROVED_SMALL;
        claims.put(each.name(), claim(each, worst(verdict, most)));
      }
      List<Claim> result = new ArrayList<>(undefined.stream().distinct().toList());
      all.forEach(each -> result.add(Objects.requireNonNull(claims.get(each.name()))));
      for (Refinement each : automaton.refinements()) {
        result.add(refinement(each, general, kept, most));
      }
      automaton.actions().forEach(action -> result.add(possible(action, kept)));
      return result;
    }

    /** What holds for any number may not stand on what holds for a few alone. */
    private List<Invariant> general(List<Invariant> kept, Map<String, Finding> findings) {
      List<Invariant> general = new ArrayList<>(kept);
      Map<String, Finding> last = new LinkedHashMap<>(findings);
      while (general.removeIf(i -> finding(last, i).verdict() != Verdict.PROVED)) {
        general.forEach(each -> last.put(each.name(), invariant(each, general, false)));
      }
      return general;
    }

    /** Invariants that hold for any number are assumed, and if that is not enough, all that hold. */
    private Claim refinement(
        Refinement of, List<Invariant> general, List<Invariant> kept, Verdict most) {
      if (most.compareTo(Verdict.PROVED_SMALL) > 0) {
        return claim(of.mapping(), most);
      }
      Claim found = beside(of, general);
      Verdict verdict = most;
      if (!found.isGood() && general.size() < kept.size()) {
        found = beside(of, kept);
        verdict = Verdict.PROVED_SMALL;
      }
      return found.isGood() ? claim(of.mapping(), worst(verdict, found.verdict())) : found;
    }

    private Claim beside(Refinement of, List<Invariant> assumed) {
      Prover prover =
          new Prover(
              of.beside(automaton),
              limit,
              (title, text) -> keep.accept("refinement-" + of.name() + "-" + title, text));
      List<Invariant> known = new ArrayList<>(assumed);
      known.add(of.mapping());
      try {
        return prover.new Induction(known).refines(of);
      } catch (Unprovable e) {
        String text = "is not decided: " + e.getMessage();
        return new Claim(of.title(), Verdict.UNDECIDED, text, List.of());
      }
    }

    /** Of the automaton beside which the abstract one is. */
    private Claim refines(Refinement of) {
      Invariant mapping = all.getLast();
      Finding found = atStart(of.start());
      Verdict verdict = Verdict.PROVED;
      for (Claim each : found.isGood() ? undefinedWith(all) : List.<Claim>of()) {
        if (!each.isGood()) {
          String text =
              (each.verdict() == Verdict.FAILED ? "fails: " : "is not decided: ")
                  + each.subject()
                  + " "
                  + each.text();
          return new Claim(
              of.title(), each.verdict(), text, each.lines(), each.action(), each.pos());
        }
        verdict = worst(verdict, each.verdict());
      }
      found = worse(found, found.isGood() ? invariant(mapping, all, false) : found);
      if (!found.isGood()) {
        List<String> lines = found.lines();
        return new Claim(
            of.title(),
            found.verdict(),
            lines.getFirst(),
            lines.subList(1, lines.size()),
            found.action(),
            Optional.empty());
      }
      return claim(mapping, worst(verdict, found.verdict()));
    }

    private static Finding finding(Map<String, Finding> findings, Invariant of) {
      return Objects.requireNonNull(findings.get(of.name()));
    }

    private static Verdict worst(List<Claim> claims) {
      return claims.stream().map(Claim::verdict).reduce(Verdict.PROVED, Induction::worst);
    }

    private static Verdict worst(Verdict a, Verdict b) {
      return a.compareTo(b) > 0 ? a : b;
    }

    private Claim claim(Invariant invariant, Verdict verdict) {
      String text =
          switch (verdict) {
            case PROVED ->
                "holds" + (isOfOneSize() ? "" : ", for " + sizes("any number of ", "any ", ""));
            case PROVED_SMALL -> "holds " + small();
            default -> "stands only on operations that have values, which is not proved";
          };
      return new Claim(invariant.name(), verdict, text, List.of());
    }

    /** Takes out what is not kept; false if there is none. */
    private boolean drop(List<Invariant> kept, Map<String, Finding> findings, List<String> failed) {
      List<String> before = List.copyOf(failed);
      List<Invariant> bad = kept.stream().filter(i -> !finding(findings, i).isGood()).toList();
      for (Invariant each : bad) {
        kept.remove(each);
        failed.add(each.name());
        Finding finding = finding(findings, each);
        claims.put(
            each.name(),
            before.isEmpty()
                ? new Claim(
                    each.name(),
                    finding.verdict(),
                    finding.lines().getFirst(),
                    finding.lines().subList(1, finding.lines().size()),
                    finding.action(),
                    Optional.empty())
                : new Claim(
                    each.name(),
                    Verdict.DEPENDS,
                    "stands only on " + String.join(", ", before) + ", not proved",
                    List.of()));
      }
      return !bad.isEmpty();
    }

    private Map<String, Finding> round(List<Invariant> assumed, boolean withStart) {
      Map<String, Finding> findings = new LinkedHashMap<>();
      for (Invariant each : assumed) {
        findings.put(each.name(), invariant(each, assumed, withStart));
      }
      return findings;
    }

    /** The worst of what is found; its first line says where. */
    private Finding invariant(Invariant invariant, List<Invariant> assumed, boolean withStart) {
      Finding worst = Finding.PROVED;
      if (withStart) {
        worst = worse(worst, atStart(invariant));
      }
      for (Action action : automaton.actions()) {
        if (worst.isGood()) {
          worst = worse(worst, kept(invariant, action, assumed));
        }
      }
      return worst;
    }

    private Finding worse(Finding a, Finding b) {
      return b.verdict().compareTo(a.verdict()) > 0 ? b : a;
    }

    private Finding atStart(Invariant invariant) {
      String title = invariant.name() + " holds at the start";
      Finding worst = Finding.PROVED;
      for (Expr part : parts(invariant.condition())) {
        Finding found =
            refute(
                title,
                size ->
                    new Question(automaton, size, title).atStart().failing(invariant.name(), part));
        worst =
            worse(
                worst,
                headed(
                    found,
                    Optional.empty(),
                    "does not hold in a start state",
                    "is not decided for start states"));
      }
      return worst;
    }

    private Finding headed(
        Finding found, Optional<String> action, String failed, String undecided) {
      if (found.isGood()) {
        return found;
      }
      List<String> lines = new ArrayList<>();
      lines.add(found.verdict() == Verdict.FAILED ? failed : undecided);
      lines.addAll(found.lines());
      return new Finding(found.verdict(), lines, action);
    }

    private Finding kept(Invariant invariant, Action action, List<Invariant> assumed) {
      String title = action.name() + " keeps " + invariant.name();
      Finding worst = Finding.PROVED;
      List<Expr> parts = parts(invariant.condition());
      for (Expr part : parts) {
        String name = title + (parts.size() > 1 ? " part " + (parts.indexOf(part) + 1) : "");
        Question any = question(0, action, assumed, invariant, part, name);
        if (assumed.contains(invariant) && any.isUntouched(part)) {
          continue;
        }
        Finding found =
            refute(name, any, size -> question(size, action, assumed, invariant, part, name));
        worst =
            worse(
                worst,
                headed(
                    found,
                    Optional.of(action.name()),
                    "is not kept by " + action.name(),
                    found.lines().isEmpty()
                        ? "is not decided for " + action.name()
                        : "is perhaps not kept by %s (with numbers to %s)"
                            .formatted(action.name(), Sorts.MOST_NUMBER)));
      }
      return worst;
    }

    private Question question(
        int size,
        Action action,
        List<Invariant> assumed,
        Invariant invariant,
        Expr part,
        String name) {
      Question question = step(size, action, assumed, name);
      question.failing(invariant.name(), part);
      frames(action).forEach(question::require);
      return question;
    }

    /** Wherever an action is enabled, and in each state an invariant, operations have values. */
    private List<Claim> undefinedWith(List<Invariant> assumed) {
      List<Claim> claims = new ArrayList<>();
      for (Action action : automaton.actions()) {
        claims.addAll(
            undefined(
                action.name(),
                (size, title) -> new Question(automaton, size, title).assuming(assumed),
                question -> question.obligations(action)));
      }
      for (Invariant each : all) {
        List<Invariant> before = all.subList(0, all.indexOf(each));
        claims.addAll(
            undefined(
                each.name(),
                (size, title) ->
                    new Question(automaton, size, title)
                        .assuming(before.stream().filter(assumed::contains).toList()),
                question -> question.obligations(List.of(each.condition()))));
      }
      return claims;
    }

    private Claim possible(Action action, List<Invariant> kept) {
      String title = action.name() + " can happen";
      Finding found =
          exists(
              title, size -> new Question(automaton, size, title).assuming(kept).enabled(action));
      if (found.verdict() == Verdict.UNDECIDED) {
        // A start state keeps them all, and is easier to find than a state in which they hold.
        String first = title + " at the start";
        Finding atStart =
            exists(first, size -> new Question(automaton, size, first).atStart().enabled(action));
        found = atStart.verdict() == Verdict.PROVED ? atStart : found;
      }
      String text =
          switch (found.verdict()) {
            case PROVED -> "can happen" + seen();
            case FAILED -> "can never happen";
            default -> "is not decided: no state found in which it can happen";
          };
      return new Claim(action.name(), found.verdict(), text, List.of());
    }
  }
}
