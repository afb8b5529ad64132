package org.starl.lang.check;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.lang.eval.Beyond;
import org.starl.lang.eval.EvalError;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Row;
import org.starl.lang.eval.Starts;
import org.starl.lang.tree.Refinement;

/** Tells a run by its steps and what each of them changes. */
final class Story {

  /** A step from one state to the next. */
  private record Step(int action, List<Object> arguments, String text, Row after) {}

  private final Machine machine;
  private final Set<String> open;
  private final List<String> lines = new ArrayList<>();
  private final Set<String> actions = new LinkedHashSet<>();
  private Row state;
  private int steps;
  private Row before;
  private @Nullable Step last;

  /**
   * @param starts the first of them that {@code path} begins with is told
   * @param path each of its states stands for all that differ from it in names alone; the run keeps
   *     to one choice of names
   */
  Story(Machine machine, Symmetry symmetry, Starts starts, List<int[]> path) {
    this.machine = machine;
    open = starts.open();
    state =
        starts.states().stream()
            .filter(each -> Arrays.equals(symmetry.representative(each), path.getFirst()))
            .findFirst()
            .orElseThrow();
    before = state;
    String start = start(state);
    if (!start.isEmpty()) {
      lines.add("0. start   " + start);
    }
    for (int[] to : path.subList(1, path.size())) {
      add(first(after -> Arrays.equals(symmetry.representative(after), to)));
    }
  }

  private void add(Step step) {
    String changes = String.join(", ", changes(state, step.after));
    lines.add(++steps + ". " + step.text + "   " + changes);
    actions.add(machine.name(step.action));
    last = step;
    before = state;
    state = step.after;
  }

  /** Takes the step of this number, from 0, of those that are possible. */
  void take(int number) {
    int[] left = {number};
    add(first(after -> left[0]-- == 0));
  }

  /** Adds a line between the steps. */
  void tell(String line) {
    lines.add(line);
  }

  List<String> lines() {
    return List.copyOf(lines);
  }

  /** The names of the actions of its steps. */
  Set<String> actions() {
    return actions;
  }

  /** The state after the steps. */
  Row end() {
    return state;
  }

  /** Adds the abstract states before and after the last step, which is not what the refinement says. */
  void tell(Refinement refinement, boolean isEnabled) {
    String name = refinement.name();
    String first = name + " starts in: ";
    if (last != null) {
      List<String> taken = machine.abstractSteps(refinement, before, last.action, last.arguments);
      String step = taken.isEmpty() ? "no step" : String.join(", ", taken);
      first = name + (isEnabled ? " takes " + step + ": " : " cannot take " + step + " in: ");
    }
    lines.add(first + machine.text(refinement, state, false));
    try {
      lines.add("the state maps to: " + machine.text(refinement, state, true));
    } catch (EvalError e) {
      lines.add("the state maps to nothing: " + e.getMessage());
    } catch (Beyond e) {
      lines.add("the state maps to a value beyond the bounds");
    }
  }

  /**
   * Adds the first step that has no value.
   *
   * @param refinement the one whose abstract step cannot be taken
   * @return what is wrong with it, in the names of this run
   */
  EvalError addFailedStep(Optional<Refinement> refinement) {
    List<Step> failed = new ArrayList<>();
    List<EvalError> errors = new ArrayList<>();
    machine.steps(
        state,
        new Machine.Steps() {
          @Override
          public void error(int action, Object[] arguments, EvalError error) {
            String text = machine.text(action, arguments);
            failed.add(new Step(action, List.of(arguments), text, state));
            errors.add(error);
          }
        });
    Step first = failed.getFirst();
    if (refinement.isEmpty()) {
      lines.add(steps + 1 + ". " + first.text);
      actions.add(machine.name(first.action));
    } else {
      Row after = machine.afterAlone(state, first.action, first.arguments);
      add(new Step(first.action, first.arguments, first.text, after));
      tell(refinement.get(), false);
    }
    return errors.getFirst();
  }

  private String start(Row state) {
    List<String> texts = new ArrayList<>();
    for (int i = 0; i < machine.parts().size(); i++) {
      Machine.Part part = machine.parts().get(i);
      if (i < machine.parameters().size() || open.contains(part.name())) {
        texts.add(part.name() + " = " + part.domain().text(state.get(i)));
      }
    }
    return String.join(", ", texts);
  }

  /** The first step to a state that is so. */
  private Step first(Predicate<Row> isSo) {
    List<Step> steps = new ArrayList<>();
    machine.steps(
        state,
        new Machine.Steps() {
          @Override
          public void step(int action, Object[] arguments, Row after) {
            if (steps.isEmpty() && isSo.test(after)) {
              steps.add(
                  new Step(action, List.of(arguments), machine.text(action, arguments), after));
            }
          }
        });
    return steps.getFirst();
  }

  private List<String> changes(Row before, Row after) {
    List<String> changes = new ArrayList<>();
    for (int i = 0; i < machine.parts().size(); i++) {
      Machine.Part part = machine.parts().get(i);
      part.domain().tellChanges(part.name(), before.get(i), after.get(i), changes);
    }
    return changes.isEmpty() ? List.of("changes nothing") : changes;
  }
}
