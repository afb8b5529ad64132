package org.starl.lang.prove;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.starl.lang.prove.Val.Cells;
import org.starl.lang.prove.Val.Fn;
import org.starl.lang.prove.Val.Term;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Action.Conjunct;
import org.starl.lang.tree.Action.Effect;
import org.starl.lang.tree.Action.Selector;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Refinement;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/** An automaton in one script: its state before, {@code s}, and after an action, {@code t}. */
final class AutomatonScript {

  private final Automaton automaton;
  private final Script script;
  private final Translator translator;

  /** Any state. */
  final Scope before;

  /**
   * @param title says what the script is about
   */
  AutomatonScript(Automaton automaton, Sorts sorts, Script script, String title) {
    this.automaton = automaton;
    this.script = script;
    script.comment(title);
    script.line("(set-logic ALL)");
    sorts.declarations().forEach(script::line);
    translator = new Translator(sorts, script);
    if (!automaton.valueParameters().isEmpty()) {
      script.comment("parameters");
      automaton
          .valueParameters()
          .forEach(p -> {
            declare("p." + p.name(), p.type());
            if (sorts.isFinite() && automaton.numbers().contains(p.name())) {
              script.require(Smt.call("<=", "p." + p.name(), String.valueOf(sorts.size())));
            }
          });
    }
    script.comment("s: a state");
    before = before();
    automaton
        .assumptions()
        .forEach(each -> {
          script.comment(each.name() + " is assumed");
          require(each.condition(), before);
        });
  }

  Translator translator() {
    return translator;
  }

  /** Any state; a component that is an abstract state is what the others map to. */
  private Scope before() {
    List<Automaton.Component> own = new ArrayList<>(automaton.state());
    automaton.refinements().forEach(of -> own.removeIf(each -> each.name().equals(of.name())));
    Map<String, Val> cells = cells(own, "s.");
    Scope state = new Scope(automaton, "s.", cells, Map.of());
    Map<String, Val> all = new LinkedHashMap<>(cells);
    for (Refinement each : automaton.refinements()) {
      if (automaton.component(each.name()).isPresent()) {
        script.comment(each.name() + ": what s maps to");
        all.put(each.name(), mapped(each, each.of(), "", state));
      }
    }
    return new Scope(automaton, "s.", all, Map.of());
  }

  private Val mapped(Refinement refinement, Automaton of, String path, Scope state) {
    Map<String, Val> cells = new LinkedHashMap<>();
    for (Automaton.Component each : of.state()) {
      String name = path + each.name();
      cells.put(
          each.name(),
          each.type() instanceof Type.StateOf used
              ? mapped(refinement, used.automaton(), name + ".", state)
              : translator.define(
                  "s." + refinement.name() + "." + name,
                  each.type(),
                  translator.as(
                      each.type(), Objects.requireNonNull(refinement.values().get(name)), state)));
    }
    return new Cells(cells);
  }

  private Val declare(String name, Type type) {
    return translator.declare(name, type);
  }

  private Map<String, Val> cells(List<Automaton.Component> state, String prefix) {
    Map<String, Val> cells = new LinkedHashMap<>();
    for (Automaton.Component each : state) {
      String name = prefix + each.name();
      cells.put(
          each.name(),
          each.type() instanceof Type.StateOf used
              ? new Cells(cells(used.automaton().state(), name + "."))
              : declare(name, each.type()));
    }
    return cells;
  }

  /** New symbols for variables, in a scope that has them. */
  Scope declared(String prefix, List<Field> variables, Scope scope) {
    Scope inner = scope;
    for (Field variable : variables) {
      inner = inner.with(variable.name(), declare(prefix + variable.name(), variable.type()));
    }
    return inner;
  }

  /** Says that an expression holds. */
  void require(Expr condition, Scope scope) {
    String text = translator.bool(condition, scope);
    script.require(text);
  }

  // --- actions -----------------------------------------------------------------------------------

  /** Says that {@code action} happens in {@link #before}; returns the scope of its parameters. */
  Scope enabled(Action action) {
    script.comment("action " + Shown.head(action));
    Scope scope = declared("a.", action.parameters(), before);
    action.pre().forEach(pre -> require(pre.condition(), scope));
    return scope;
  }

  /** The state after {@code action}. */
  Scope after(Action action, Scope parameters) {
    script.comment("t: the state after");
    Map<String, Val> cells = after(action, parameters, before.cells());
    return new Scope(automaton, "t.", defined(automaton, "t.", cells, before.cells()), Map.of());
  }

  private Map<String, Val> after(Action action, Scope scope, Map<String, Val> now) {
    Map<String, Val> next = new LinkedHashMap<>(now);
    for (Effect effect : action.eff()) {
      if (effect instanceof Effect.Assign assign) {
        Type type = scope.automaton().component(assign.component()).orElseThrow().type();
        Val old = Objects.requireNonNull(next.get(assign.component()));
        next.put(assign.component(), changed(old, type, assign.selectors(), assign.value(), scope));
      } else if (effect instanceof Effect.Step step) {
        Scope used =
            scope
                .used(step.used())
                .only(
                    step.action().parameters(),
                    translator.arguments(step.action().parameters(), step.arguments(), scope));
        Map<String, Val> cells = ((Cells) Objects.requireNonNull(next.get(step.used()))).cells();
        Map<String, Val> then = after(step.action(), used, cells);
        next.put(
            step.used(),
            new Cells(
                step.condition().isEmpty()
                    ? then
                    : either(translator.bool(step.condition().get(), scope), then, cells)));
      }
    }
    return next;
  }

  /**
   * A change by an action.
   *
   * @param place names of components and fields, and lists of arguments
   * @param guard the condition of the step that makes it
   */
  private record Change(List<Object> place, String guard, Val value, Type type, Pos pos) {}

  /** What must hold so that {@code action} has an effect wherever it is enabled. */
  List<Obligation> obligations(Action action, Scope parameters) {
    return translator.obligations(() -> {
      String enabled =
          translator.all(action.pre().stream().map(Conjunct::condition).toList(), parameters);
      List<Change> changes = new ArrayList<>();
      translator.under(
          enabled,
          () -> {
            changes(action, parameters, List.of(), Smt.TRUE, changes);
            for (int i = 0; i < changes.size(); i++) {
              for (Change other : changes.subList(0, i)) {
                String apart = apart(other, changes.get(i));
                translator.oblige(apart, "changes one place twice", changes.get(i).pos());
              }
            }
            return enabled;
          });
    });
  }

  private void changes(
      Action action, Scope scope, List<Object> prefix, String guard, List<Change> changes) {
    for (Effect effect : action.eff()) {
      List<Object> place = new ArrayList<>(prefix);
      if (effect instanceof Effect.Assign assign) {
        place.add(assign.component());
        Type type = scope.automaton().component(assign.component()).orElseThrow().type();
        for (Selector selector : assign.selectors()) {
          if (selector instanceof Selector.At at) {
            List<Field> parameters =
                Sorts.map(type).arguments().stream().map(of -> new Field("", of)).toList();
            place.add(
                translator.terms(
                    parameters, translator.arguments(parameters, at.arguments(), scope)));
            type = Sorts.map(type).result();
          } else if (selector instanceof Selector.Of of) {
            place.add(of.field());
            type = ((Type.Rec) type.base()).field(of.field()).orElseThrow().type();
          }
        }
        Val value = translator.as(type, assign.value(), scope);
        changes.add(new Change(place, guard, value, type, assign.pos()));
      } else if (effect instanceof Effect.Step step) {
        place.add(step.used());
        List<Field> parameters = step.action().parameters();
        String condition = step.condition().map(of -> translator.bool(of, scope)).orElse(Smt.TRUE);
        translator.under(
            condition,
            () -> {
              Scope used =
                  scope
                      .used(step.used())
                      .only(parameters, translator.arguments(parameters, step.arguments(), scope));
              String enabled =
                  translator.all(
                      step.action().pre().stream().map(Conjunct::condition).toList(), used);
              String name = step.used() + "." + step.action().name();
              translator.oblige(enabled, "takes " + name + " where it is not enabled", step.pos());
              String both = Smt.and(List.of(guard, condition));
              translator.under(
                  enabled,
                  () -> {
                    changes(step.action(), used, place, both, changes);
                    return enabled;
                  });
              return enabled;
            });
      }
    }
  }

  /** That two changes are not made at one place, or are equal. */
  private String apart(Change one, Change other) {
    List<String> overlap = new ArrayList<>(List.of(one.guard(), other.guard()));
    int common = Math.min(one.place().size(), other.place().size());
    for (int i = 0; i < common; i++) {
      if (one.place().get(i) instanceof List<?> a && other.place().get(i) instanceof List<?> b) {
        for (int k = 0; k < a.size(); k++) {
          overlap.add(Smt.equal(String.valueOf(a.get(k)), String.valueOf(b.get(k))));
        }
      } else if (!one.place().get(i).equals(other.place().get(i))) {
        return Smt.TRUE;
      }
    }
    return Smt.implies(
        Smt.and(overlap),
        one.place().size() == other.place().size()
            ? translator.equal(one.type(), one.value(), other.value())
            : "false");
  }

  /** The components {@code then} if the condition holds, and {@code otherwise} if not. */
  private Map<String, Val> either(
      String condition, Map<String, Val> then, Map<String, Val> otherwise) {
    Map<String, Val> all = new LinkedHashMap<>();
    then.forEach((name, value) -> {
      Val other = Objects.requireNonNull(otherwise.get(name));
      all.put(
          name,
          value.equals(other)
              ? value
              : value instanceof Cells inner
                  ? new Cells(either(condition, inner.cells(), ((Cells) other).cells()))
                  : translator.ite(condition, value, other));
    });
    return all;
  }

  private Val changed(Val old, Type type, List<Selector> selectors, Expr value, Scope scope) {
    if (selectors.isEmpty()) {
      return translator.as(type, value, scope);
    }
    List<Selector> rest = selectors.subList(1, selectors.size());
    return switch (selectors.getFirst()) {
      case Selector.At at -> {
        Fn map = (Fn) old;
        List<Field> parameters =
            map.type().arguments().stream().map(argument -> new Field("", argument)).toList();
        List<String> place =
            translator.terms(parameters, translator.arguments(parameters, at.arguments(), scope));
        Val there = changed(map.at().apply(place), map.type().result(), rest, value, scope);
        yield new Fn(
            map.type(),
            x -> {
              List<String> same = new ArrayList<>();
              for (int i = 0; i < x.size(); i++) {
                same.add(Smt.equal(x.get(i), place.get(i)));
              }
              return translator.ite(Smt.and(same), there, map.at().apply(x));
            },
            null);
      }
      case Selector.Of of -> {
        Type.Rec rec = (Type.Rec) type.base();
        List<String> values = new ArrayList<>();
        for (Field field : rec.fields()) {
          Val part = translator.field(rec, field, Val.smt(old));
          boolean isIt = field.name().equals(of.field());
          Val next = isIt ? changed(part, field.type(), rest, value, scope) : part;
          values.add(translator.term(next, field.type()));
        }
        yield new Term(Smt.call("mk." + translator.sorts().sort(rec), values));
      }
    };
  }

  /** Names for the components that are changed. */
  private Map<String, Val> defined(
      Automaton of, String prefix, Map<String, Val> cells, Map<String, Val> old) {
    Map<String, Val> named = new LinkedHashMap<>();
    for (Automaton.Component each : of.state()) {
      Val value = Objects.requireNonNull(cells.get(each.name()));
      Val was = Objects.requireNonNull(old.get(each.name()));
      if (value.equals(was)) {
        named.put(each.name(), was);
      } else if (each.type() instanceof Type.StateOf used) {
        Map<String, Val> inner = ((Cells) value).cells();
        String path = prefix + each.name() + ".";
        named.put(
            each.name(), new Cells(defined(used.automaton(), path, inner, ((Cells) was).cells())));
      } else {
        named.put(each.name(), translator.define(prefix + each.name(), each.type(), value));
      }
    }
    return named;
  }
}
