package org.starl.lang.check;

import java.util.ArrayList;
import java.util.LinkedHashMap;
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
import org.starl.lang.eval.Witness;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.verdict.Verdict;

/** Visits all states of an automaton that can be reached. */
public final class Search {

  /**
   * What a search found.
   *
   * @param states the number of those visited; of states that differ in names alone, one counts
   * @param steps the number of steps from them
   * @param depth the number of steps to the farthest of them
   * @param stopped why the search ended early; empty if it did not
   * @param symmetric the types whose elements were renamed
   * @param asymmetric the types of which there are too many elements for this
   * @param open the parts that the start leaves open, and of which all values were visited
   * @param cut the parts that the start leaves open, and of which the first value was visited alone
   * @param bounded the value parameters that may have more values, beyond the bounds
   * @param untried of what some values were not tried, nor any that stands for them: {@code d of dt}
   * @param beyond the number of steps that lead beyond the bounds, and were not taken
   * @param beyondArguments the number of cases of arguments beyond the bounds that were not decided
   * @param unevaluated the invariants that were beyond the bounds in some states, with the number of these
   * @param never the actions that cannot happen
   * @param neverFalse for each action, the conjuncts that are true wherever those before them are
   * @param finding empty if nothing is wrong
   */
  public record Result(
      int states,
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
      Optional<Finding> finding) {

    /** Whether the search ended by itself. */
    public boolean isComplete() {
      return stopped.isEmpty() && finding.isEmpty();
    }

    /** What comes of it. */
    public Verdict verdict() {
      if (finding.isPresent()) {
        return Verdict.VIOLATED;
      }
      return undecided().isEmpty() ? Verdict.HOLDS : Verdict.NOT_DECIDED;
    }

    /** What was not looked at; empty if it was all. */
    List<String> undecided() {
      List<String> all = new ArrayList<>();
      if (!stopped.isEmpty()) {
        all.add("THE SEARCH DID NOT END");
      } else if (states == 0) {
        all.add("THERE IS NO START STATE");
      }
      if (beyond + beyondArguments > 0) {
        all.add("steps are not taken");
      }
      if (!unevaluated.isEmpty()) {
        all.add("invariants are not evaluated in some states");
      }
      if (!cut.isEmpty() || !untried.isEmpty()) {
        all.add("values are not tried");
      }
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

  private final Machine machine;
  private final Automaton automaton;
  private final Symmetry symmetry;
  private final States states;
  private final Starts starts;
  private final int most;

  private final long[] taken;
  private final boolean[][] falses;
  private final Map<String, Long> unevaluated = new LinkedHashMap<>();
  private long steps;
  private long beyond;
  private long beyondArguments;
  private String stopped = "";

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
    symmetry = new Symmetry(machine, sizes.opaque(), isSymmetric);
    states = new States(machine.parts().size());
    taken = new long[automaton.actions().size()];
    falses = new boolean[taken.length][];
    for (int i = 0; i < taken.length; i++) {
      falses[i] = new boolean[automaton.actions().get(i).pre().size()];
    }
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
    int depth = 0;
    Finding finding = null;
    try {
      starts.states().forEach(start -> visit(symmetry.representative(start), -1));
      int end = states.size(); // of the states at this depth
      for (int number = 0; number < states.size(); number++) {
        if (isInterrupted.getAsBoolean()) {
          stopped = "interrupted";
          break;
        }
        if (number == end) {
          depth++;
          end = states.size();
        }
        expand(number);
      }
    } catch (Found found) {
      finding = found.finding;
    } catch (OutOfMemoryError e) {
      states.clear();
      stopped = "memory ran out";
    }
    return result(depth, finding);
  }

  /** The states visited so far, in order. */
  List<Row> visited() {
    return IntStream.range(0, states.size()).mapToObj(i -> symmetry.state(states.get(i))).toList();
  }

  private Result result(int depth, @Nullable Finding finding) {
    List<String> never = new ArrayList<>();
    Map<String, List<String>> neverFalse = new LinkedHashMap<>();
    boolean isComplete = finding == null && stopped.isEmpty();
    List<String> untried = new ArrayList<>();
    for (int i = 0; i < taken.length; i++) {
      String name = automaton.actions().get(i).name();
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
    for (int i = 0; i < taken.length && isComplete; i++) {
      Action action = automaton.actions().get(i);
      if (taken[i] == 0) {
        never.add(action.name());
        continue;
      }
      List<String> texts = new ArrayList<>();
      for (int c = 0; c < falses[i].length; c++) {
        if (!falses[i][c]) {
          texts.add(action.pre().get(c).text());
        }
      }
      if (!texts.isEmpty()) {
        neverFalse.put(action.name(), List.copyOf(texts));
      }
    }
    return new Result(
        states.size(),
        steps,
        depth,
        stopped,
        symmetry.types(),
        symmetry.tooLarge(),
        starts.open(),
        starts.cut(),
        bounded,
        untried,
        beyond,
        beyondArguments,
        unevaluated,
        never,
        neverFalse,
        Optional.ofNullable(finding));
  }

  private void visit(int[] numbers, int parent) {
    if (states.size() == most) {
      stopped =
          "--most "
              + most
              + " is reached"; // the states that are left are expanded, for what can be found of
      // them
      return;
    }
    if (!states.add(numbers, parent)) {
      return;
    }
    Row visited = symmetry.state(numbers);
    for (Invariant invariant : automaton.invariants()) {
      try {
        if (!machine.holds(invariant, visited)) {
          found(invariant, null, states.size() - 1);
        }
      } catch (Beyond e) {
        unevaluated.merge(invariant.name(), 1L, Long::sum);
      } catch (EvalError e) {
        found(invariant, e, states.size() - 1);
      }
    }
  }

  /** One of {@code invariant} and {@code error} may be null. */
  private void found(@Nullable Invariant invariant, @Nullable EvalError error, int number) {
    List<int[]> path = new ArrayList<>();
    for (int at = number; at >= 0; at = states.parent(at)) {
      path.add(states.get(at));
    }
    Story story = new Story(machine, symmetry, starts.open(), path.reversed());
    if (invariant == null) {
      story.addFailedStep();
    }
    String name = invariant == null ? "" : invariant.name();
    if (error != null) {
      String message = String.valueOf(error.getMessage());
      throw new Found(
          new Finding(
              name,
              path.size() - 1,
              story.lines(),
              error.automaton(),
              error.pos(),
              false,
              message));
    }
    Witness witness = machine.witness(Objects.requireNonNull(invariant), story.end());
    String message =
        "false"
            + (witness.variables().isEmpty() ? "" : " for " + witness.variables())
            + (witness.why().isEmpty() ? "" : ": " + witness.why());
    throw new Found(
        new Finding(
            name, path.size() - 1, story.lines(), automaton.name(), witness.pos(), true, message));
  }

  private void expand(int number) {
    int[] numbers = states.get(number);
    Row state = symmetry.state(numbers);
    machine.steps(
        state,
        new Machine.Steps() {
          @Override
          public void step(int action, Object[] arguments, Row after) {
            taken[action]++;
            steps += machine.areWithin(action, arguments) ? 1 : 0;
            visit(symmetry.representative(after, state, numbers), number);
          }

          @Override
          public void beyond(int action, Object[] arguments) {
            if (machine.areWithin(action, arguments)) {
              beyond++;
            } else {
              beyondArguments++;
            }
          }

          @Override
          public void conjunctIsFalse(int action, int conjunct) {
            falses[action][conjunct] = true;
          }

          @Override
          public void error(int action, Object[] arguments, EvalError error) {
            found(null, error, number);
          }
        });
  }
}
