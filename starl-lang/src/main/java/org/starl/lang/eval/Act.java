package org.starl.lang.eval;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.starl.lang.eval.Code.Frame;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Action.Effect;
import org.starl.lang.tree.Action.Selector;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Type;

/** An action that is ready to be taken. */
final class Act {

  /** A change of a part of the state. */
  private static final class Change {

    /** The component, then places within it. */
    final int[] path;

    final Object value;
    final Pos pos;

    Change(int[] path, Object value, Pos pos) {
      this.path = path;
      this.value = value;
      this.pos = pos;
    }
  }

  private interface Collector {

    void collect(Frame frame, int[] prefix, List<Change> changes);
  }

  final Action tree;
  final List<Domain> parameters;

  /** The number of parameters that must have values before each conjunct can be evaluated. */
  final int[] levels;

  private final Compiler compiler;
  private final Code[] pre;
  private final List<Collector> effects = new ArrayList<>();
  private final Compiler.Scope scope = new Compiler.Scope();

  Act(Action tree, Compiler compiler) {
    this.tree = tree;
    this.compiler = compiler;
    parameters = compiler.bind(tree.parameters(), scope, tree.pos());
    pre = new Code[tree.pre().size()];
    levels = new int[pre.length];
    int level = 0;
    for (int i = 0; i < pre.length; i++) {
      scope.read.clear();
      pre[i] = compiler.code(tree.pre().get(i).condition(), scope);
      // A conjunct may rely on those before it: it waits for their parameters, too.
      int last = scope.read.previousSetBit(parameters.size() - 1);
      level = Math.max(level, last + 1);
      levels[i] = level;
    }
    tree.eff().forEach(effect -> effects.add(effect(effect)));
  }

  /** Its parameters, and room for other variables. */
  Object[] locals() {
    return new Object[scope.most];
  }

  Object[] locals(List<?> arguments) {
    return Arrays.copyOf(arguments.toArray(), scope.most);
  }

  boolean test(int conjunct, Frame frame) {
    return pre[conjunct].test(frame);
  }

  /** The number of the first conjunct that is false; -1 if all are true. */
  int firstFalse(Frame frame) {
    return IntStream.range(0, pre.length).filter(i -> !test(i, frame)).findFirst().orElse(-1);
  }

  /** The state after it, which is {@code frame.root}. */
  Row after(Frame frame) {
    List<Change> changes = new ArrayList<>();
    effects.forEach(effect -> effect.collect(frame, new int[0], changes));
    Row row = new Row(frame.root);
    for (int i = 0; i < changes.size(); i++) {
      Change change = changes.get(i);
      requireApart(change, changes.subList(0, i));
      row = (Row) changed(row, change, 0);
    }
    return row;
  }

  private static Object changed(Object old, Change change, int depth) {
    if (depth == change.path.length) {
      return change.value;
    }
    int place = change.path[depth];
    return ((Row) old).with(place, changed(((Row) old).get(place), change, depth + 1));
  }

  private void requireApart(Change change, List<Change> before) {
    for (Change other : before) {
      int common = Math.min(change.path.length, other.path.length);
      boolean overlaps = Arrays.equals(change.path, 0, common, other.path, 0, common);
      boolean isSame = change.path.length == other.path.length && change.value.equals(other.value);
      if (overlaps && !isSame) {
        throw compiler.error(
            change.pos, "'" + tree.name() + "' changes one place twice; expected one effect on it");
      }
    }
  }

  private Collector effect(Effect effect) {
    return switch (effect) {
      case Effect.Assign assign -> assign(assign);
      case Effect.Step step -> step(step);
    };
  }

  private Collector assign(Effect.Assign assign) {
    int component = compiler.component(assign.component());
    Type type = compiler.automaton().state().get(component).type();
    Domain domain = compiler.domains().of(type);
    List<Code.Index> path = new ArrayList<>();
    path.add(frame -> frame.offset + component);
    for (Selector selector : assign.selectors()) {
      if (selector instanceof Selector.At at) {
        Domain.Maps map = (Domain.Maps) domain;
        path.add(compiler.index(map, at.arguments(), scope));
        domain = map.result;
      } else if (selector instanceof Selector.Of of) {
        Domain.Records rec = (Domain.Records) domain;
        int field = rec.names.indexOf(of.field());
        path.add(frame -> field);
        domain = rec.fields.parts.get(field);
      }
    }
    Code value = compiler.code(assign.value(), scope);
    Domain of = domain;
    return (frame, prefix, changes) -> {
      int[] places = Arrays.copyOf(prefix, prefix.length + path.size());
      for (int i = 0; i < path.size(); i++) {
        places[prefix.length + i] = path.get(i).of(frame);
      }
      Object after = value.of(frame);
      if (!of.contains(after)) {
        throw new Beyond();
      }
      changes.add(new Change(places, after, assign.pos()));
    };
  }

  /** A step of a used automaton, which must be enabled there. */
  private Collector step(Effect.Step step) {
    Act act = new Act(step.action(), compiler.used(step.used()));
    int component = compiler.component(step.used());
    Code[] arguments = compiler.codes(step.arguments(), scope);
    Code condition = step.condition().map(each -> compiler.code(each, scope)).orElse(frame -> true);
    return (frame, prefix, changes) -> {
      if (!condition.test(frame)) {
        return;
      }
      Row given = Compiler.row(arguments, frame);
      Frame inside = Compiler.inside(frame, component, act.locals(List.of(given.items())));
      int isFalse = act.firstFalse(inside);
      if (isFalse >= 0) {
        throw compiler.error(
            step.pos(),
            "%s.%s is not enabled: '%s' is false"
                .formatted(
                    step.used(), act.text(given.items()), act.tree.pre().get(isFalse).text()));
      }
      int[] places = Arrays.copyOf(prefix, prefix.length + 1);
      places[prefix.length] = frame.offset + component;
      act.effects.forEach(effect -> effect.collect(inside, places, changes));
    };
  }

  /** The steps of used automata whose conditions hold, as in {@code od_mutex(bot0, {A})}. */
  List<String> texts(List<Effect.Step> steps, Frame frame) {
    List<String> texts = new ArrayList<>();
    for (Effect.Step step : steps) {
      if (step.condition().isEmpty() || compiler.code(step.condition().get(), scope).test(frame)) {
        Row given = Compiler.row(compiler.codes(step.arguments(), scope), frame);
        texts.add(new Act(step.action(), compiler.used(step.used())).text(given.items()));
      }
    }
    return texts;
  }

  /** With these arguments; there may be fewer than parameters. */
  String text(Object[] arguments) {
    List<String> texts = new ArrayList<>();
    for (int i = 0; i < Math.min(arguments.length, parameters.size()); i++) {
      texts.add(parameters.get(i).text(arguments[i]));
    }
    return tree.name() + "(" + String.join(", ", texts) + ")";
  }
}
