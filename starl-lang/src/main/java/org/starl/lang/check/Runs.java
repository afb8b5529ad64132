package org.starl.lang.check;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.starl.lang.check.FairLoops.Assumed;
import org.starl.lang.check.FairLoops.Lasso;
import org.starl.lang.eval.Beyond;
import org.starl.lang.eval.EvalError;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Row;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.tree.Automaton.Progress;
import org.starl.lang.tree.Expr;

/** Asks whether what is to happen does, in all runs through the visited states. */
final class Runs {

  private static final int MOST_NAMED = 8;

  /** So many starts are left out, one by one, where runs from them leave open what is assumed. */
  private static final int MOST_STARTS = 64;

  private final Search search;
  private final Machine machine;
  private final States states;
  private final Graph graph;
  private final List<Assumed> assumed = new ArrayList<>();

  /** The states in which a condition is beyond the bounds: no run through these is told. */
  private final BitSet undecided = new BitSet();

  Runs(Search search, Graph graph) {
    this.search = search;
    this.graph = graph;
    machine = search.machine;
    states = search.states;
  }

  /** The first run in which something does not happen. */
  Optional<Finding> find() {
    BitSet all = new BitSet();
    all.set(0, states.size());
    BitSet starts = new BitSet();
    all.stream().filter(state -> states.parent(state) < 0).forEach(starts::set);
    List<Progress> progress = search.automaton.progress();
    for (int i = 0; i < progress.size(); i++) {
      if (progress.get(i).isAssumed()) {
        int number = i;
        asked(i, all)
            .forEach((values, from) -> assumed.add(new Assumed(from, met(number, values, all))));
      }
    }
    if (!undecided.isEmpty()) {
      return Optional.empty(); // it is not known which runs are left out
    }
    FairLoops loops = new FairLoops(graph, states, assumed);
    boolean isSure = !assumed.isEmpty() && graph.incomplete.isEmpty() && !starts.isEmpty();
    if (isSure && loops.find(starts, all).isEmpty()) {
      search.unasked.add("NO RUN IS AS PROGRESS IS ASSUMED");
      return Optional.empty();
    }
    return IntStream.range(0, progress.size())
        .filter(i -> !progress.get(i).isAssumed())
        .boxed()
        .flatMap(i -> find(i, progress.get(i).isOfStart() ? starts : all, all, loops).stream())
        .findFirst();
  }

  /** Where the left side holds, for all values for which it does somewhere. */
  private Map<Row, BitSet> asked(int progress, BitSet of) {
    Map<Row, BitSet> where = new LinkedHashMap<>();
    for (int state = of.nextSetBit(0); state >= 0; state = of.nextSetBit(state + 1)) {
      int number = state;
      machine.steps(
          search.successors.row(states.get(state)),
          side(progress, 0),
          new Machine.Steps() {
            @Override
            public void step(int action, Object[] values, Row after) {
              Row key = Row.of(List.of(values));
              where.computeIfAbsent(key, fresh -> new BitSet()).set(number);
            }

            @Override
            public void beyond(int action, Object[] values) {
              addUndecided(progress, number);
            }

            @Override
            public void error(int action, Object[] values, EvalError error) {
              search.found(invariant(progress), error, number);
            }
          });
    }
    return where;
  }

  /** Where the right side holds for these values. */
  private BitSet met(int progress, Row values, BitSet of) {
    BitSet where = new BitSet();
    List<Object> arguments = arguments(values);
    for (int state = of.nextSetBit(0); state >= 0; state = of.nextSetBit(state + 1)) {
      Row row = search.successors.row(states.get(state));
      try {
        where.set(state, machine.firstFalse(row, side(progress, 1), arguments).isEmpty());
      } catch (Beyond e) {
        addUndecided(progress, state);
      } catch (EvalError e) {
        search.found(invariant(progress), e, state);
      }
    }
    return where;
  }

  private static List<Object> arguments(Row values) {
    return IntStream.range(0, values.size()).mapToObj(values::get).toList();
  }

  private int side(int progress, int side) {
    return search.automaton.actions().size() + 2 * progress + side;
  }

  private Invariant invariant(int progress) {
    Progress of = search.automaton.progress().get(progress);
    Expr to = of.to().pre().getFirst().condition();
    return new Invariant(of.name(), to, List.of(), to.pos());
  }

  private void addUndecided(int progress, int state) {
    undecided.set(state);
    search.counts.unevaluated.merge(
        search.automaton.progress().get(progress).name(), 1L, Long::sum);
  }

  private Optional<Finding> find(int claim, BitSet of, BitSet all, FairLoops loops) {
    undecided.clear();
    String name = search.automaton.progress().get(claim).name();
    Map<Row, BitSet> from = asked(claim, of);
    if (from.isEmpty() && !of.isEmpty()) {
      search.never.add("the left side of " + name);
    }
    boolean isOpen = false;
    for (Map.Entry<Row, BitSet> each : from.entrySet()) {
      BitSet allowed = met(claim, each.getKey(), all);
      allowed.or(undecided);
      allowed.flip(0, states.size());
      BitSet sources = each.getValue();
      Optional<Lasso> lasso = loops.find(sources, allowed);
      for (int i = 0; i < MOST_STARTS && lasso.filter(this::isOwed).isPresent(); i++) {
        isOpen = true;
        int start = start(lasso.get().source());
        int[] same = sources.stream().filter(state -> start(state) == start).toArray();
        Arrays.stream(same).forEach(sources::clear);
        lasso = loops.find(sources, allowed);
      }
      if (lasso.filter(run -> !isOwed(run)).isPresent()) {
        return Optional.of(tell(claim, each.getKey(), lasso.get()));
      }
    }
    if (isOpen) {
      search.unasked.add(name + " is broken by a run that leaves open what is assumed");
    }
    return Optional.empty();
  }

  private int start(int state) {
    int start = state;
    while (states.parent(start) >= 0) {
      start = states.parent(start);
    }
    return start;
  }

  private boolean isOwed(Lasso lasso) {
    return assumed.stream().anyMatch(each -> isOwed(each, lasso));
  }

  /** Whether the run comes to its loop before what is assumed has happened, and it never does. */
  private boolean isOwed(Assumed assumed, Lasso lasso) {
    List<Integer> path = states.pathTo(lasso.source());
    lasso.toLoop().forEach(step -> path.add(graph.target(step)));
    boolean isOwed = false;
    for (int state : path) {
      isOwed = (isOwed || assumed.from().get(state)) && !assumed.to().get(state);
    }
    return isOwed && lasso.loop().stream().noneMatch(s -> assumed.to().get(graph.target(s)));
  }

  private Finding tell(int number, Row values, Lasso lasso) {
    Progress claim = search.automaton.progress().get(number);
    List<Integer> path = states.pathTo(lasso.source());
    Story story = search.story(path);
    int before = path.size() - 1 + lasso.toLoop().size();
    int entry = take(story, lasso.source(), lasso.toLoop());
    String what = "nothing more happens after " + steps(before);
    if (lasso.loop().isEmpty()) {
      story.tell("then nothing more happens");
    } else {
      story.tell("then again and again:");
      take(story, entry, lasso.loop());
      what = "%s come round for ever after %s".formatted(steps(lasso.loop().size()), steps(before));
    }
    tellFair(story, entry, lasso.loop());
    String message =
        machine.text(side(number, 0), arguments(values).toArray())
            + (claim.isOfStart()
                ? " never happens"
                : ": the left side holds after %s, and the right side never then"
                    .formatted(steps(path.size() - 1)));
    return new Finding(
        claim.name(),
        "is false: " + what,
        before,
        story.lines(),
        story.actions(),
        search.automaton.name(),
        claim.to().pos(),
        message,
        search.unaskedOf(path.getFirst()));
  }

  /** Takes steps by their numbers; returns the state after them. */
  private int take(Story story, int from, List<Integer> steps) {
    int at = from;
    for (int step : steps) {
      story.take(step - graph.first(at));
      at = graph.target(step);
    }
    return at;
  }

  private void tellFair(Story story, int entry, List<Integer> loop) {
    BitSet taken = new BitSet();
    BitSet free = graph.possible(entry);
    for (int step : loop) {
      free.or(graph.possible(graph.target(step)));
      taken.set(Math.max(graph.label(step), 0), graph.label(step) + 1);
    }
    BitSet impossible = new BitSet();
    impossible.set(0, graph.texts.size());
    impossible.andNot(free);
    free.andNot(taken);
    tell(story, "fair, and taken there: ", taken);
    tell(story, "fair, and possible there at times, but not all the time: ", free);
    tell(story, "fair, and never possible there: ", impossible);
  }

  private void tell(Story story, String what, BitSet labels) {
    if (!labels.isEmpty()) {
      List<String> names = labels.stream().mapToObj(graph.texts::get).limit(MOST_NAMED).toList();
      int more = labels.cardinality() - names.size();
      story.tell(
          what + String.join(", ", names) + (more > 0 ? " and %,d more".formatted(more) : ""));
    }
  }

  private static String steps(int number) {
    return Report.count(number, "step");
  }
}
