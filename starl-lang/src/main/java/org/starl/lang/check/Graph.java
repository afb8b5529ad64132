package org.starl.lang.check;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Row;
import org.starl.lang.tree.Action.Fairness;

/** The steps between the visited states. Each has a label: the number of what is fair with it. */
final class Graph {

  private static final int NOT_FAIR = -1;

  private final Machine machine;
  private final Map<Row, Integer> labels = new LinkedHashMap<>();

  /** Of each label, as in {@code release(bot0, {A})}. */
  final List<String> texts = new ArrayList<>();

  /** The labels that are strongly fair. */
  final BitSet strong = new BitSet();

  /** The states of which not all steps are taken. */
  final BitSet incomplete = new BitSet();

  private int[] firsts = new int[1024];
  private int[] targets = new int[4096];
  private int[] label = new int[4096];
  private int states;
  private int steps;

  Graph(Machine machine) {
    this.machine = machine;
  }

  /** The steps that are added next are those of the next state. */
  void beginState() {
    if (states == firsts.length) {
      firsts = Arrays.copyOf(firsts, 2 * states);
    }
    firsts[states++] = steps;
  }

  /** The last state has a step that is not taken. */
  void addUntaken() {
    incomplete.set(states - 1);
  }

  /**
   * Adds a step of the last state.
   *
   * @param target below 0 if the step is not taken
   */
  void add(int action, Object[] arguments, int target) {
    if (target < 0) {
      addUntaken();
    }
    if (steps == targets.length) {
      targets = Arrays.copyOf(targets, 2 * steps);
      label = Arrays.copyOf(label, 2 * steps);
    }
    Optional<Fairness> fairness = machine.automaton().actions().get(action).fairness();
    targets[steps] = target;
    label[steps++] = fairness.isEmpty() ? NOT_FAIR : label(fairness.get(), action, arguments);
  }

  /** The steps of the first states. */
  void write(int first, DataOutput out) throws IOException {
    int last = first < states ? firsts[first] : steps;
    for (int state = 0; state < first; state++) {
      out.writeInt(end(state) - first(state));
      out.writeBoolean(incomplete.get(state));
    }
    for (int step = 0; step < last; step++) {
      out.writeInt(targets[step]);
      out.writeInt(label[step]);
    }
    out.writeInt(texts.size());
    int number = 0;
    for (Row key : labels.keySet()) {
      ValueForm.write(key, out);
      out.writeUTF(texts.get(number));
      out.writeBoolean(strong.get(number++));
    }
  }

  /** Adds the steps of so many states as they were written; there is none yet. */
  void read(int first, DataInput in) throws IOException {
    firsts = new int[Math.max(first, firsts.length)];
    for (; states < first; states++) {
      firsts[states] = steps;
      steps = Math.addExact(steps, in.readInt());
      incomplete.set(states, in.readBoolean());
    }
    targets = new int[Math.max(steps, targets.length)];
    label = new int[targets.length];
    for (int step = 0; step < steps; step++) {
      targets[step] = in.readInt();
      label[step] = in.readInt();
    }
    for (int left = in.readInt(); left > 0; left--) {
      labels.put((Row) ValueForm.read(in), texts.size());
      texts.add(in.readUTF());
      strong.set(texts.size() - 1, in.readBoolean());
    }
  }

  private int label(Fairness fairness, int action, Object[] arguments) {
    List<Object> key = new ArrayList<>(List.of(fairness.group()));
    fairness.each().forEach(i -> key.add(arguments[i]));
    Integer known = labels.putIfAbsent(Row.of(key), texts.size());
    if (known == null) {
      texts.add(machine.text(fairness, action, arguments));
    }
    int number = known == null ? texts.size() - 1 : known;
    strong.set(number, strong.get(number) || fairness.isStrong());
    return number;
  }

  int states() {
    return states;
  }

  /** The number of the first step of a state. */
  int first(int state) {
    return firsts[state];
  }

  /** After the number of its last step. */
  int end(int state) {
    return state + 1 < states ? firsts[state + 1] : steps;
  }

  int target(int step) {
    return targets[step];
  }

  /** Below 0 if the step need not be taken. */
  int label(int step) {
    return label[step];
  }

  /** The labels of the steps of a state. */
  BitSet possible(int state) {
    BitSet labels = new BitSet();
    for (int step = first(state); step < end(state); step++) {
      if (label[step] >= 0) {
        labels.set(label[step]);
      }
    }
    return labels;
  }
}
