package org.starl.lang.eval;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.starl.lang.tree.Action.Effect;
import org.starl.lang.tree.Automaton.Invariant;

/**
 * The steps of states that are given by the numbers of their parts' values. Most states share most parts
 * with others: what a condition or an effect gives is remembered for the numbers of the parts that it
 * reads. Where it has no value, or one beyond the bounds, it is evaluated again. Not thread-safe.
 */
public final class Successors {

  /** The values of each part by their numbers. */
  public interface Numbers {

    /** The number of a value. */
    int number(int part, Object value);

    /** The value of a number. */
    Object value(int part, int number);
  }

  /** Is told the steps of a state. */
  public interface Steps extends Machine.Steps {

    /** A step that can be taken; {@code after} are the numbers of the state after it. */
    void step(int action, Object[] arguments, int[] after);
  }

  /** Of an action with more choices of arguments, or sets of them, nothing is remembered. */
  private static final int MOST = 1 << 16;

  /** A part that an action changes, and what the number of its value is then, plus 1. */
  private record Change(int part, Memo memo) {}

  private final Machine machine;
  private final Numbers numbers;
  private final List<Plan> plans = new ArrayList<>();
  private final IdentityHashMap<Invariant, Memo> holding = new IdentityHashMap<>();

  /** The state that is looked at, and its values if they were needed. */
  private int[] state = {};

  private @Nullable Row row;

  /** The steps of a machine's states. */
  public Successors(Machine machine, Numbers numbers) {
    this.machine = machine;
    this.numbers = numbers;
    for (int i = 0; i < machine.automaton().actions().size(); i++) {
      plans.add(new Plan(i, machine.act(i)));
    }
  }

  /** Tells all steps of a state, in the order of the actions and of the values of their parameters. */
  public void steps(int[] of, Steps to) {
    state = of;
    row = null;
    for (Plan plan : plans) {
      plan.tell(to);
    }
  }

  /** As {@link Machine#holds}. */
  public boolean holds(Invariant invariant, int[] of) {
    Memo memo = holding.get(invariant);
    if (memo == null) {
      memo = new Memo(1, machine.reads().add(invariant.condition()));
      holding.put(invariant, memo);
    }
    if (memo.get(of, 0) > 0) {
      return true;
    }
    boolean holds = machine.holds(invariant, row(of));
    memo.put(of, 0, holds ? 1 : 0);
    return holds;
  }

  private Row row() {
    if (row == null) {
      row = row(state);
    }
    return row;
  }

  /** The state of these numbers. */
  public Row row(int[] of) {
    return new Row(IntStream.range(0, of.length).mapToObj(i -> numbers.value(i, of[i])).toArray());
  }

  /** Tells the steps of an action. */
  private final class Plan {

    private final int action;
    private final Object[][] arguments;
    private final List<Change> changes = new ArrayList<>();

    /** The number of the set of choices of arguments for which it is enabled, plus 1. */
    private final Memo enabled;

    private final List<int[]> sets = new ArrayList<>();
    private final Map<List<Integer>, Integer> known = new LinkedHashMap<>();

    Plan(int action, Act act) {
      this.action = action;
      long all =
          act.parameters.stream()
              .mapToLong(p -> p.size() > MOST ? p.size() : p.instances().size())
              .reduce(1, Domain::times);
      int kinds = all > MOST ? 0 : (int) all;
      arguments = new Object[kinds][];
      enabled = new Memo(Math.min(1, kinds), machine.reads().addAll(act.tree.pre()));
      Map<Integer, Reads> reads = new LinkedHashMap<>();
      for (Effect effect : act.tree.eff()) {
        int part = machine.reads().add(effect);
        reads.computeIfAbsent(part, any -> machine.reads()).add(effect);
      }
      reads.forEach((part, of) -> changes.add(new Change(part, new Memo(kinds, of))));
    }

    void tell(Steps to) {
      int set = enabled.get(state, 0);
      if (set > 0) {
        for (int choice : sets.get(set - 1)) {
          take(choice, arguments[choice], to);
        }
        return;
      }
      List<Integer> choices = new ArrayList<>();
      boolean isDecided =
          machine.steps(
              row(),
              action,
              to,
              (choice, of) -> {
                if (arguments.length > 0) {
                  arguments[choice] = of;
                  choices.add(choice);
                }
                take(choice, of, to);
              });
      if (isDecided && sets.size() < MOST) {
        Integer before = known.putIfAbsent(choices, sets.size() + 1);
        if (before == null) {
          sets.add(choices.stream().mapToInt(Integer::intValue).toArray());
        }
        enabled.put(state, 0, before == null ? sets.size() : before);
      }
    }

    private void take(int choice, Object[] of, Steps to) {
      int[] after = state.clone();
      for (Change change : changes) {
        after[change.part] = change.memo.get(state, choice) - 1;
        if (after[change.part] < 0) {
          Row found = machine.after(row(), action, of, to);
          if (found == null) {
            return;
          }
          changes.forEach(each -> evaluated(each, choice, found, after));
          break;
        }
      }
      to.step(action, of, after);
    }

    private void evaluated(Change change, int choice, Row found, int[] after) {
      Object value = found.get(change.part);
      boolean isSame = value == row().get(change.part);
      after[change.part] = isSame ? state[change.part] : numbers.number(change.part, value);
      change.memo.put(state, choice, after[change.part] + 1);
    }
  }
}
