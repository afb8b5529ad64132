package org.starl.lang.check;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.starl.lang.eval.Beyond;
import org.starl.lang.eval.EvalError;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Row;
import org.starl.lang.eval.Sizes;
import org.starl.lang.eval.Starts;
import org.starl.lang.eval.Successors;
import org.starl.lang.eval.Witness;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.tree.Refinement;
import org.starl.lang.verdict.Verdict;

/** Visits all states of an automaton that can be reached. */
public final class Search {

  /**
   * What a search found.
   *
   * @param states the number of those visited in which all constraints hold; of states that differ in
   *     names alone, one counts
   * @param outside the number of those in which a constraint is false: their steps are not looked at
   * @param steps the number of steps from them
   * @param depth the number of steps to the farthest of them
   * @param stopped why the search ended early; empty if it did not
   * @param symmetric the types whose elements were renamed
   * @param asymmetric those of them with so many orders of elements that not all were tried in some state
   * @param open the parts that the start leaves open, and of which all values were visited
   * @param cut the parts that the start leaves open, and of which the first value was visited alone
   * @param bounded the value parameters that may have more values, beyond the bounds
   * @param untried of what some values were not tried, nor any that stands for them: {@code d of dt}
   * @param beyond the number of steps that lead beyond the bounds, and were not taken
   * @param beyondArguments the number of cases of arguments beyond the bounds that were not decided
   * @param unevaluated the conditions that were beyond the bounds in some states, with the number of these
   * @param never the actions that cannot happen
   * @param neverFalse for each action, the conjuncts that are true wherever those before them are
   * @param unasked why progress is not decided; empty if it is
   * @param finding empty if nothing is wrong
   */
  public record Result(
      int states,
      int outside,
      long steps,
      int depth,
      String stopped,
      List<String> symmetric,
      List<String> asymmetric,
      Set<String> open,
      Set<String> cut,
      Set<String> bounded,
      List<String> untried,
      long beyond,
      long beyondArguments,
      Map<String, Long> unevaluated,
      List<String> never,
      Map<String, List<String>> neverFalse,
      List<String> unasked,
      Optional<Finding> finding) {

    /** Whether the search ended by itself. */
    public boolean isComplete() {
      return stopped.isEmpty() && finding.isEmpty();
    }

    /** What comes of it. */
    public Verdict verdict() {
      if (finding.isPresent()) {
        return finding.get().unasked().isEmpty() ? Verdict.VIOLATED : Verdict.NOT_DECIDED;
      }
      return undecided().isEmpty() ? Verdict.HOLDS : Verdict.NOT_DECIDED;
    }

    /** What was not looked at; empty if it was all. */
    List<String> undecided() {
      List<String> all = new ArrayList<>();
      if (!stopped.isEmpty()) {
        all.add("THE SEARCH DID NOT END");
      } else if (states + outside == 0) {
        all.add("THERE IS NO START STATE");
      } else if (states == 0) {
        all.add("NO START STATE SATISFIES THE CONSTRAINTS");
      }
      if (beyond + beyondArguments > 0) {
        all.add("steps are not taken");
      }
      if (!unevaluated.isEmpty()) {
        all.add("conditions are not evaluated in some states");
      }
      if (!cut.isEmpty() || !untried.isEmpty()) {
        all.add("values are not tried");
      }
      all.addAll(unasked);
      return all;
    }
  }

  /** Leaves the search at a finding. */
  private static final class Found extends RuntimeException {

    private static final long serialVersionUID = 1L;

    final transient Finding finding;

    Found(Finding finding) {
      super("found", null, false, false);
      this.finding = finding;
    }
  }

  final Machine machine;
  final Automaton automaton;
  final Symmetry symmetry;
  final States states;
  final Starts starts;
  final Successors successors;
  private final List<Invariant> ofStarts;
  private final int most;

  final Counts counts;
  final List<String> never = new ArrayList<>();
  final List<String> unasked = new ArrayList<>();
  private String stopped = "";

  /** Null if no progress is asked that needs it. */
  @Nullable Graph graph;

  /** The next state whose steps are looked at; those before {@code end} are as deep as it. */
  int next;

  int end;
  int depth;

  /** Null if the search is not to be saved. */
  private @Nullable Checkpoint checkpoint;

  /**
   * @param given the values of value parameters that are given
   * @param isSymmetric whether of states that differ in names alone one is visited
   * @param most the largest number of states
   * @throws org.starl.lang.eval.TooLarge if there are too many start states, or values of a type
   * @throws EvalError if the start condition has no value
   */
  public Search(
      Machine machine, Sizes sizes, Map<String, Object> given, boolean isSymmetric, int most) {
    this.machine = machine;
    this.most = most;
    automaton = machine.automaton();
    starts = machine.starts(given);
    ofStarts = automaton.starts();
    counts = new Counts(automaton.actions());
    counts.unevaluated.putAll(starts.unasked());
    boolean needsGraph = needsGraph(automaton);
    graph = needsGraph ? new Graph(machine) : null;
    Map<String, Integer> alike = new LinkedHashMap<>(sizes.opaque());
    alike.keySet().removeAll(machine.chosen());
    symmetry = new Symmetry(machine, alike, isSymmetric && !needsGraph);
    successors = new Successors(machine, symmetry);
    states = new States(machine.parts().size());
  }

  /**
   * The search can be saved from now on, where it ends early; call it before the search runs, or is read
   * from a file.
   */
  public Checkpoint checkpoint() {
    checkpoint = new Checkpoint(this);
    return checkpoint;
  }

  /**
   * Whether all runs are looked at, for progress. Then states that differ in names alone count each:
   * that bot0 waits and that bot1 waits may not be taken for one.
   */
  static boolean needsGraph(Automaton automaton) {
    return automaton.progress().stream().anyMatch(each -> !each.isAssumed());
  }

  /** Visits the states. */
  public Result run() {
    return run(() -> false);
  }

  /**
   * Visits the states, until memory runs out or {@code isInterrupted}.
   *
   * @param isInterrupted is asked before the steps of each state
   */
  public Result run(BooleanSupplier isInterrupted) {
    Finding finding = null;
    try {
      if (states.size() == 0) {
        starts.states().forEach(start -> visit(symmetry.representative(start), -1));
        end = states.size();
      }
      for (; next < states.size(); next++) {
        if (checkpoint != null && stopped.isEmpty()) {
          checkpoint.mark();
        }
        if (isInterrupted.getAsBoolean()) {
          stopped = "interrupted";
          break;
        }
        if (next == end) {
          depth++;
          end = states.size();
        }
        expand(next);
      }
      if (graph != null && graph.states() == states.size()) {
        finding = new Runs(this, graph).find().orElse(null);
        if (counts.outside > 0) {
          unasked.add("progress of runs that leave the constraints");
        }
      }
    } catch (Found found) {
      finding = found.finding;
    } catch (OutOfMemoryError e) {
      if (checkpoint == null) {
        states.clear();
        graph = null;
      }
      stopped = "memory ran out";
    }
    return result(finding);
  }

  /** The number of states visited so far. */
  public int size() {
    return states.size();
  }

  /** The number of states whose steps were looked at so far. */
  public int next() {
    return next;
  }

  /** The states visited so far, in order. */
  List<Row> visited() {
    return IntStream.range(0, states.size()).mapToObj(i -> successors.row(states.get(i))).toList();
  }

  private Result result(@Nullable Finding finding) {
    Map<String, List<String>> neverFalse = new LinkedHashMap<>();
    boolean isComplete = finding == null && stopped.isEmpty();
    Set<String> untried = new LinkedHashSet<>(); // both sides of a progress have the same variables
    List<Action> all = new ArrayList<>(automaton.actions());
    all.addAll(automaton.sides());
    for (int i = 0; i < all.size(); i++) {
      String name = all.get(i).name();
      machine.untried(i).forEach(parameter -> untried.add(parameter + " of " + name));
    }
    Set<String> bounded = new TreeSet<>();
    for (int i = 0; i < machine.parts().size(); i++) {
      String part = machine.parts().get(i).name();
      if (starts.bounded().contains(part)) {
        if (i < machine.parameters().size()) {
          bounded.add(part);
        } else {
          untried.add(part + " at the start");
        }
      }
    }
    for (int i = 0; i < counts.taken.length && isComplete; i++) {
      Action action = automaton.actions().get(i);
      if (counts.taken[i] == 0) {
        never.add(action.name());
        continue;
      }
      List<String> texts = new ArrayList<>();
      for (int c = 0; c < counts.falses[i].length; c++) {
        if (!counts.falses[i][c]) {
          texts.add(action.pre().get(c).text());
        }
      }
      if (!texts.isEmpty()) {
        neverFalse.put(action.name(), List.copyOf(texts));
      }
    }
    return new Result(
        states.size() - counts.outside,
        counts.outside,
        counts.steps,
        depth,
        stopped,
        symmetry.types(),
        symmetry.tooMany(),
        starts.open(),
        starts.cut(),
        bounded,
        List.copyOf(untried),
        counts.beyond,
        counts.beyondArguments,
        counts.unevaluated,
        never,
        neverFalse,
        unasked,
        Optional.ofNullable(finding));
  }

  /** Returns the state's number; below 0 if there is no room for it. */
  private int visit(int[] numbers, int parent) {
    if (states.size() == most) {
      int known = states.number(numbers);
      if (known < 0) { // the states that are left are expanded, for what can be found of them
        stopped = "--most " + most + " is reached";
      }
      return known;
    }
    int before = states.size();
    int number = states.add(numbers, parent);
    if (number == before) {
      ask(automaton.invariants(), numbers, number);
      if (parent < 0) {
        ask(ofStarts, numbers, number);
      }
      counts.outside += isWithin(numbers, number, true) ? 0 : 1;
    }
    return number;
  }

  private void ask(List<Invariant> invariants, int[] state, int number) {
    for (Invariant invariant : invariants) {
      try {
        if (!successors.holds(invariant, state)) {
          found(invariant, null, number);
        }
      } catch (Beyond e) {
        counts.unevaluated.merge(invariant.name(), 1L, Long::sum);
      } catch (EvalError e) {
        found(invariant, e, number);
      }
    }
  }

  /** Whether all constraints hold; a state of which this is not known is none to go on from. */
  private boolean isWithin(int[] state, int number, boolean isNew) {
    for (Invariant constraint : automaton.constraints()) {
      try {
        if (!successors.holds(constraint, state)) {
          return false;
        }
      } catch (Beyond e) {
        counts.unevaluated.merge(constraint.name(), isNew ? 1L : 0L, Long::sum);
        return false;
      } catch (EvalError e) {
        found(constraint, e, number);
      }
    }
    return true;
  }

  /** Tells a run by the numbers of its states. */
  Story story(List<Integer> path) {
    return new Story(machine, symmetry, starts, path.stream().map(states::get).toList());
  }

  /** The refinement that fails, if it is one. */
  private Optional<Refinement> refinement(
      @Nullable Invariant invariant, @Nullable EvalError error) {
    return automaton.refinements().stream()
        .filter(each ->
            invariant != null
                ? each.title().equals(invariant.name())
                : error != null
                    && error.automaton().equals(automaton.name())
                    && each.isStep(error.pos()))
        .findFirst();
  }

  /** One of {@code invariant} and {@code first}, the first error, may be null. */
  void found(@Nullable Invariant invariant, @Nullable EvalError first, int number) {
    List<Integer> path = states.pathTo(number);
    Story story = story(path);
    Optional<Refinement> refinement = refinement(invariant, first);
    EvalError error = first;
    if (invariant == null) {
      error = story.addFailedStep(refinement);
    } else if (error == null) {
      refinement.ifPresent(each -> story.tell(each, true));
    }
    String name =
        invariant == null ? refinement.map(Refinement::title).orElse("") : invariant.name();
    boolean isStep = invariant == null && refinement.isPresent();
    int steps = path.size() - (isStep ? 0 : 1);
    if (error != null) {
      String message = String.valueOf(error.getMessage());
      throw new Found(
          new Finding(
              name,
              (isStep ? "is false after " : "is undefined after ") + Report.count(steps, "step"),
              steps,
              story.lines(),
              story.actions(),
              error.automaton(),
              error.pos(),
              message,
              unaskedOf(path.getFirst())));
    }
    Witness witness = machine.witness(Objects.requireNonNull(invariant), story.end());
    String message =
        "false"
            + (witness.variables().isEmpty() ? "" : " for " + witness.variables())
            + (witness.why().isEmpty() ? "" : ": " + witness.why());
    throw new Found(
        new Finding(
            name,
            (automaton.ends().contains(invariant)
                    ? "is false: nothing can happen after "
                    : "is false after ")
                + Report.count(steps, "step"),
            steps,
            story.lines(),
            story.actions(),
            automaton.name(),
            witness.pos(),
            message,
            unaskedOf(path.getFirst())));
  }

  /** The assumptions, or the start, that are not decided of a start state. */
  Set<String> unaskedOf(int start) {
    return starts.states().stream()
        .filter(each -> states.number(symmetry.representative(each)) == start)
        .map(starts::unasked)
        .min(Comparator.comparingInt(Set::size))
        .orElse(Set.of());
  }

  private void expand(int number) {
    int[] state = states.get(number);
    boolean[] isEnd = {true};
    if (graph != null) {
      graph.beginState();
    }
    if (!isWithin(state, number, false)) {
      if (graph != null) {
        graph.addUntaken();
      }
      return;
    }
    successors.steps(
        state,
        new Successors.Steps() {
          @Override
          public void step(int action, Object[] arguments, int[] after) {
            counts.taken[action]++;
            counts.steps += machine.areWithin(action, arguments) ? 1 : 0;
            isEnd[0] = false;
            int to = visit(symmetry.representative(after), number);
            if (graph != null) {
              graph.add(action, arguments, to);
            }
          }

          @Override
          public void beyond(int action, Object[] arguments) {
            isEnd[0] = false;
            if (graph != null) {
              graph.addUntaken();
            }
            if (machine.areWithin(action, arguments)) {
              counts.beyond++;
            } else {
              counts.beyondArguments++;
            }
          }

          @Override
          public void conjunctIsFalse(int action, int conjunct) {
            counts.falses[action][conjunct] = true;
          }

          @Override
          public void error(int action, Object[] arguments, EvalError error) {
            found(null, error, number);
          }
        });
    if (isEnd[0]) {
      ask(automaton.ends(), state, number);
    }
  }
}
