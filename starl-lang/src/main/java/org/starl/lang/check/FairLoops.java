package org.starl.lang.check;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import org.jspecify.annotations.Nullable;

/**
 * Finds fair runs that never leave a set of states. In the end, such a run visits some states again
 * and again, which are strongly connected; or it stops in one state. Of a strongly connected part, all
 * states can be visited again and again, and all its steps taken. If this is not fair, the states are
 * left out where something is possible that is owed, and the rest is looked at again (Emerson and Lei,
 * 1985).
 */
final class FairLoops {

  /**
   * A run: a shortest run to {@code source}, then steps to the loop, then the loop for ever.
   *
   * @param toLoop numbers of steps
   * @param loop numbers of steps; none if the run stops
   */
  record Lasso(int source, List<Integer> toLoop, List<Integer> loop) {}

  /** Runs are left out in which {@code from} holds in a state, and {@code to} never then. */
  record Assumed(BitSet from, BitSet to) {}

  private final Graph graph;
  private final States states;
  private final List<Assumed> assumed;

  /** For each state, the part that it is in now; 0 if in none. */
  private final int[] part;

  /** The state and the step by which a breadth-first search came to a state. */
  private final int[] before;

  private final int[] by;

  /** Of Tarjan's algorithm; the step to follow next. */
  private final int[] index;

  private final int[] low;
  private final int[] next;
  private int parts;

  FairLoops(Graph graph, States states, List<Assumed> assumed) {
    this.graph = graph;
    this.states = states;
    this.assumed = assumed;
    part = new int[graph.states()];
    before = new int[graph.states()];
    by = new int[graph.states()];
    index = new int[graph.states()];
    low = new int[graph.states()];
    next = new int[graph.states()];
  }

  /**
   * A run that visits a state of {@code sources} and then stays in {@code allowed}; of those found, one
   * that comes soonest to the states that it visits again and again.
   */
  Optional<Lasso> find(BitSet sources, BitSet allowed) {
    Arrays.fill(part, 0);
    int[] reached = reached(sources, allowed);
    Deque<int[]> open = new ArrayDeque<>();
    open.add(Arrays.stream(reached).filter(s -> !graph.incomplete.get(s)).toArray());
    BitSet good = new BitSet();
    List<int[]> fair = new ArrayList<>();
    while (!open.isEmpty()) {
      for (int[] component : components(open.pop())) {
        int[] rest = fairRest(component);
        if (rest.length == component.length) {
          Arrays.stream(component).forEach(good::set);
          fair.add(component);
        } else if (rest.length > 0) {
          open.push(rest);
        }
      }
    }
    if (fair.isEmpty()) {
      return Optional.empty();
    }
    int entry = Arrays.stream(reached).filter(good::get).findFirst().getAsInt();
    List<Integer> toLoop = new ArrayList<>();
    int source = entry;
    for (; by[source] >= 0; source = before[source]) {
      toLoop.add(by[source]);
    }
    fair.removeIf(component -> Arrays.stream(component).noneMatch(state -> state == entry));
    return Optional.of(new Lasso(source, toLoop.reversed(), loop(entry, fair.getFirst())));
  }

  /** The states that are reached within {@code allowed}, those first that are nearest to a start. */
  private int[] reached(BitSet sources, BitSet allowed) {
    int[] depth = new int[graph.states()];
    for (int state = 0; state < depth.length; state++) {
      depth[state] = states.parent(state) < 0 ? 0 : depth[states.parent(state)] + 1;
    }
    int[] order = new int[graph.states()];
    BitSet seen = (BitSet) allowed.clone();
    seen.flip(0, graph.states());
    int size = 0;
    int done = 0;
    int source = sources.nextSetBit(0);
    for (int level = 0; done < size || source >= 0; level++) {
      for (; source >= 0 && depth[source] <= level; source = sources.nextSetBit(source + 1)) {
        if (!seen.get(source)) {
          seen.set(source);
          by[source] = -1;
          order[size++] = source;
        }
      }
      for (int end = size; done < end; done++) {
        int state = order[done];
        for (int step = graph.first(state); step < graph.end(state); step++) {
          int target = graph.target(step);
          if (target >= 0 && !seen.get(target)) {
            seen.set(target);
            before[target] = state;
            by[target] = step;
            order[size++] = target;
          }
        }
      }
    }
    return Arrays.copyOf(order, size);
  }

  /** The strongly connected components of some states, by Tarjan's algorithm, without recursion. */
  private List<int[]> components(int[] of) {
    int inside = mark(of);
    List<int[]> components = new ArrayList<>();
    Arrays.stream(of).forEach(state -> index[state] = 0);
    int[] path = new int[of.length];
    int[] stack = new int[of.length];
    int depth = 0;
    int height = 0;
    int count = 0;
    for (int root : of) {
      if (index[root] == 0) {
        path[depth++] = root;
      }
      while (depth > 0) {
        int state = path[depth - 1];
        if (index[state] == 0) {
          index[state] = ++count;
          low[state] = count;
          next[state] = graph.first(state);
          stack[height++] = state;
        }
        if (next[state] < graph.end(state)) {
          int target = graph.target(next[state]++);
          if (part[target] == inside && index[target] == 0) {
            path[depth++] = target;
          } else if (part[target] == inside) { // else its component is complete
            low[state] = Math.min(low[state], index[target]);
          }
          continue;
        }
        depth--;
        if (depth > 0) {
          low[path[depth - 1]] = Math.min(low[path[depth - 1]], low[state]);
        }
        if (low[state] == index[state]) {
          int from = height;
          do {
            part[stack[--from]] = 0;
          } while (stack[from] != state);
          components.add(Arrays.copyOfRange(stack, from, height));
          height = from;
        }
      }
    }
    return components;
  }

  private int mark(int[] members) {
    parts++;
    for (int state : members) {
      part[state] = parts;
    }
    return parts;
  }

  private boolean isInside(int step, int inside) {
    return graph.target(step) >= 0 && part[graph.target(step)] == inside;
  }

  /** What fairness owes to a run that takes these, and visits these states again and again. */
  private BitSet owed(int[] visited, BitSet taken) {
    BitSet always = new BitSet();
    always.set(0, graph.texts.size());
    BitSet ever = new BitSet();
    for (int state : visited) {
      BitSet possible = graph.possible(state);
      always.and(possible);
      ever.or(possible);
    }
    ever.and(graph.strong);
    ever.or(always);
    ever.andNot(taken);
    return ever;
  }

  /** The states of a component to which a fair run may keep: all of them if it is fair itself. */
  private int[] fairRest(int[] component) {
    int inside = mark(component);
    BitSet taken = new BitSet();
    for (int state : component) {
      for (int step = graph.first(state); step < graph.end(state); step++) {
        if (graph.label(step) >= 0 && isInside(step, inside)) {
          taken.set(graph.label(step));
        }
      }
    }
    BitSet owed = owed(component, taken);
    List<BitSet> left = new ArrayList<>();
    for (Assumed each : assumed) {
      if (Arrays.stream(component).noneMatch(each.to::get)) {
        left.add(each.from);
      }
    }
    Arrays.stream(component).forEach(state -> part[state] = 0);
    return Arrays.stream(component)
        .filter(state -> left.stream().noneMatch(from -> from.get(state)))
        .filter(state -> owed.isEmpty() || !graph.possible(state).intersects(owed))
        .toArray();
  }

  /** A short way from {@code entry} round to it that is fair; the component is. */
  private List<Integer> loop(int entry, int[] component) {
    int inside = mark(component);
    List<Integer> steps = new ArrayList<>();
    for (IntPredicate via = missing(entry, steps); via != null; via = missing(entry, steps)) {
      follow(entry, inside, via, steps);
      int end = graph.target(steps.getLast());
      if (end != entry) {
        follow(end, inside, step -> graph.target(step) == entry, steps);
      }
    }
    return steps;
  }

  /** The steps of which a loop needs one to be fair; null if it is. */
  private @Nullable IntPredicate missing(int entry, List<Integer> steps) {
    BitSet visited = new BitSet();
    visited.set(entry);
    BitSet taken = new BitSet();
    for (int step : steps) {
      visited.set(graph.target(step));
      if (graph.label(step) >= 0) {
        taken.set(graph.label(step));
      }
    }
    int label = owed(visited.stream().toArray(), taken).nextSetBit(0);
    if (label >= 0) {
      boolean isStrong = graph.strong.get(label);
      return step ->
          graph.label(step) == label
              || (!isStrong && !graph.possible(graph.target(step)).get(label));
    }
    for (Assumed each : assumed) {
      if (visited.intersects(each.from) && !visited.intersects(each.to)) {
        return step -> each.to.get(graph.target(step));
      }
    }
    return null;
  }

  /** Adds a shortest way within a part, whose last step is as wanted. */
  private void follow(int from, int inside, IntPredicate isLast, List<Integer> steps) {
    BitSet seen = new BitSet();
    Deque<Integer> queue = new ArrayDeque<>(List.of(from));
    seen.set(from);
    while (true) {
      int state = queue.remove();
      for (int step = graph.first(state); step < graph.end(state); step++) {
        int target = graph.target(step);
        if (isInside(step, inside) && isLast.test(step)) {
          List<Integer> back = new ArrayList<>(List.of(step));
          for (int at = state; at != from; at = before[at]) {
            back.add(by[at]);
          }
          steps.addAll(back.reversed());
          return;
        }
        if (isInside(step, inside) && !seen.get(target)) {
          seen.set(target);
          before[target] = state;
          by[target] = step;
          queue.add(target);
        }
      }
    }
  }
}
