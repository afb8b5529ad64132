package org.starl.lang.java;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Action.Conjunct;
import org.starl.lang.tree.Action.Effect;
import org.starl.lang.tree.Action.Selector;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Component;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/** Writes the body of {@code XAutomaton}. */
final class AutomatonWriter {

  private static final String IS_ENABLED = "enabled(action, s).isTrue()";

  // The components of a state that each action writes again, changed or not.
  private static final int MOST_REPEATED = 5;

  private final Automaton automaton;
  private final JavaTypes types;
  private final Names names;
  private final String file;
  private final JavaText out = new JavaText();

  /**
   * @param file the name of the source
   */
  AutomatonWriter(Automaton automaton, JavaTypes types, Names names, String file) {
    this.automaton = automaton;
    this.types = types;
    this.names = names;
    this.file = file;
  }

  /** All that follows the imports. */
  String body() {
    List<String> about = new ArrayList<>();
    about.add("The automaton " + automaton.name() + ", executable.");
    if (!automaton.comment().isEmpty()) {
      about.add("");
      about.addAll(automaton.comment());
    }
    out.doc(0, about, List.of());
    String interfaces = "<" + names.automaton() + ".States, " + names.action() + "> {";
    Layout head = new Layout().token("public final class " + names.automaton()).open(4).brk(" ");
    out.add(
        0,
        head.token("implements ")
            .token(types.use("org.starl.spec.automaton.Automaton") + interfaces)
            .close());
    out.blank().line(2, "/** The theory's name. */");
    String constant = names.constant();
    out.line(2, "public static final String " + constant + " = \"" + automaton.name() + "\";");
    used();
    parameters();
    new TypesWriter(automaton, types, out).write();
    states();
    out.blank().line(2, "@Override").line(2, "public String theory() {");
    out.line(4, "return " + constant + ";").line(2, "}");
    out.blank().line(2, "@Override").line(2, "public States start() {");
    StartState start = new StartState(own -> new ExpressionWriter(automaton, types, file, own));
    out.returned(4, start.of(automaton)).line(2, "}");
    Functions.written(automaton, true).forEach(f -> function(2, f, "s"));
    Functions.written(automaton, false).stream()
        .filter(f -> !f.signature().readsState())
        .forEach(f -> function(2, f, ""));
    enabled();
    trans();
    return out.line(0, "}").toString();
  }

  /** A field for each automaton that it uses. */
  private void used() {
    if (!automaton.uses().isEmpty()) {
      out.blank();
    }
    automaton
        .uses()
        .forEach((component, used) -> {
          String type = types.automaton(used);
          String field = "private final " + type + " " + ExpressionWriter.machine(component);
          boolean isGiven = used.valueParameters().isEmpty();
          out.line(2, field + (isGiven ? " = new " + type + "();" : ";"));
        });
  }

  /** They have the parameters of the same names. */
  private void makeUsed() {
    automaton
        .uses()
        .forEach((component, used) -> {
          List<Code> given =
              used.valueParameters().stream()
                  .map(each -> Code.name(JavaTypes.name(each.name())))
                  .toList();
          if (!given.isEmpty()) {
            out.statement(
                4,
                "this." + ExpressionWriter.machine(component) + " = ",
                new Code.New(types.automaton(used), given));
          }
        });
  }

  private ExpressionWriter writer(String state) {
    return new ExpressionWriter(automaton, types, state, file);
  }

  private void parameters() {
    if (automaton.valueParameters().isEmpty()) {
      return;
    }
    out.blank();
    List<String> parameters = new ArrayList<>();
    for (Field each : automaton.valueParameters()) {
      String parameter = given(each) + " " + JavaTypes.name(each.name());
      parameters.add(parameter);
      out.line(2, "private final " + parameter + ";");
    }
    out.blank().line(2, "/** Of the theory's parameters. */");
    out.head(2, "public " + names.automaton(), parameters, List.of(" {"));
    for (Field each : automaton.valueParameters()) {
      String name = JavaTypes.name(each.name());
      boolean isSet =
          each.type().base() instanceof Type.SetOf
              && types.form(each.type()) == JavaTypes.Sets.FINITE;
      String value =
          isSet ? types.use("org.starl.spec.automaton.Sets") + ".of(" + name + ")" : name;
      out.line(4, "this." + name + " = " + value + ";");
    }
    makeUsed();
    automaton.maybeEmpty().forEach(range -> out.statement(4, "", writer("").of(range)));
    out.line(2, "}");
    for (Field each : automaton.valueParameters()) {
      if (!(each.type().base() instanceof Type.MapOf)) {
        String name = JavaTypes.name(each.name());
        out.blank().line(2, "/** The theory's parameter. */");
        out.line(2, "public " + given(each) + " " + name + "() {");
        out.line(4, "return " + name + ";").line(2, "}");
      }
    }
  }

  /** The Java type of a value parameter. */
  private String given(Field parameter) {
    Pos pos = automaton.pos();
    if (!(parameter.type().base() instanceof Type.MapOf map)) {
      return types.of(parameter.type(), pos);
    }
    int arity = map.arguments().size();
    if (arity > 2) {
      throw new NotExecutable(
          pos, "'" + parameter.name() + "' has " + arity + " arguments; expected at most 2");
    }
    boolean isCondition = map.result().base() == Type.Bool.BOOL;
    String name = (arity == 2 ? "Bi" : "") + (isCondition ? "Predicate" : "Function");
    List<String> arguments = new ArrayList<>();
    map.arguments().forEach(each -> arguments.add(types.boxed(each, pos)));
    if (!isCondition) {
      arguments.add(types.boxed(map.result(), pos));
    }
    return types.use("java.util.function." + name) + "<" + String.join(", ", arguments) + ">";
  }

  private void states() {
    List<String> tags = new ArrayList<>();
    List<String> parts = new ArrayList<>();
    for (Component each : automaton.state()) {
      String name = JavaTypes.name(each.name());
      parts.add(types.of(each.type(), automaton.pos()) + " " + name);
      String about = (String.join(" ", each.comment()) + " " + each.note()).strip();
      if (!about.isEmpty()) {
        tags.add("@param " + name + " " + JavaText.escaped(about));
      }
    }
    out.blank().doc(2, List.of("The states."), tags);
    var functions =
        Functions.written(automaton, false).stream()
            .filter(f -> f.signature().readsState())
            .toList();
    List<Component> changing = changing();
    boolean isBare = functions.isEmpty() && changing.isEmpty();
    out.head(2, "public record States", parts, List.of(isBare ? " {}" : " {"));
    if (!isBare) {
      functions.forEach(f -> function(4, f, ""));
      changing.forEach(this::other);
      out.line(2, "}");
    }
  }

  /** A method that makes the state with another value of a component. */
  private void other(Component component) {
    String parameter =
        types.of(component.type(), automaton.pos()) + " " + JavaTypes.name(component.name());
    out.blank().head(4, "private States " + with(component), List.of(parameter), List.of(" {"));
    List<Code> all =
        automaton.state().stream().map(c -> Code.name(JavaTypes.name(c.name()))).toList();
    out.returned(6, new Code.New("States", all)).line(4, "}");
  }

  private void function(int indent, org.starl.lang.tree.Function f, String state) {
    String name = JavaTypes.function(f.signature().name());
    Pos pos = f.pos();
    List<String> parameters = new ArrayList<>();
    for (Field each : f.signature().parameters()) {
      String variable = JavaTypes.variable(each.name());
      parameters.add(types.of(each.type(), pos) + " " + variable);
    }
    boolean isStatic = state.isEmpty() && !f.signature().readsState();
    if (!state.isEmpty() && f.signature().readsState()) {
      parameters.add("States s");
    }
    ExpressionWriter writer = writer(state);
    f.signature()
        .parameters()
        .forEach(p -> writer.bind(p.name(), Code.name(JavaTypes.variable(p.name()))));
    String type = types.of(f.signature().result(), pos);
    out.blank().doc(indent, f.comment(), List.of());
    out.head(
        indent,
        "public " + (isStatic ? "static " : "") + type + " " + name,
        parameters,
        List.of(" {"));
    if (Recursion.isCounted(f)) {
      Recursion.write(indent + 2, f, writer, out);
    } else {
      out.returned(indent + 2, writer.of(f.body()));
    }
    out.line(indent, "}");
  }

  private void enabled() {
    String enabled = types.use("org.starl.spec.automaton.Enabled");
    out.blank().line(2, "@Override");
    out.line(2, "public " + enabled + " enabled(" + names.action() + " action, States s) {");
    cases(action -> {
      Code guard = Code.name(enabled).field("TRUE");
      ExpressionWriter writer = writer(action);
      for (int i = 0; i < action.pre().size(); i++) {
        Code[] conjunct = conjunct(action.pre().get(i), i == 0, writer);
        guard = i == 0 ? Code.call(enabled + ".when", conjunct) : guard.then("and", conjunct);
      }
      return guard;
    });
  }

  /** The arguments of {@code when} and {@code and}. */
  private Code[] conjunct(Conjunct of, boolean isFirst, ExpressionWriter writer) {
    Code text = Code.string(of.text());
    // Those before may be what gives it a value.
    boolean isLate = !isFirst && Functions.isPartial(automaton, of.condition());
    if (of.condition() instanceof Expr.Enabled step && !isLate) {
      return new Code[] {text, writer.enabled(step)};
    }
    Code holds = writer.of(of.condition());
    Code values = new Code.Lambda("()", writer.untold(() -> new Values(writer).of(of.condition())));
    return new Code[] {text, isLate ? new Code.Lambda("()", holds) : holds, values};
  }

  private void trans() {
    out.blank().line(2, "@Override");
    out.line(2, "public States trans(" + names.action() + " action, States s) {");
    cases(action -> {
      ExpressionWriter writer = writer(action);
      Map<String, Code> changed = new LinkedHashMap<>();
      for (Effect effect : action.eff()) {
        switch (effect) {
          case Effect.Assign assign -> {
            Code before =
                changed.getOrDefault(assign.component(), writer.component(assign.component()));
            Type type = automaton.component(assign.component()).orElseThrow().type();
            changed.put(
                assign.component(),
                changed(before, type, assign.selectors(), writer.of(assign.value()), writer));
          }
          case Effect.Step step -> {
            Code before = changed.getOrDefault(step.used(), writer.component(step.used()));
            changed.put(step.used(), step(step, before, writer));
          }
        }
      }
      if (changed.isEmpty()) {
        return Code.name("s");
      }
      Code after = once(action, after(changed, writer), writer);
      // As in the theory: an effect that may have no value is one where the action is enabled.
      return action.eff().stream().anyMatch(this::isPartial)
          ? Code.choice(Code.name(IS_ENABLED), after, Code.name("s"))
          : after;
    });
  }

  /** The state with other values of some components. */
  private Code after(Map<String, Code> changed, ExpressionWriter writer) {
    if (!isLarge()) {
      return new Code.New(
          "States",
          automaton.state().stream()
              .map(c -> changed.getOrDefault(c.name(), writer.component(c.name())))
              .toList());
    }
    Code after = Code.name("s");
    for (Component each : automaton.state()) {
      Code value = changed.get(each.name());
      after = value == null ? after : after.then(with(each), value);
    }
    return after;
  }

  private String with(Component component) {
    String name = "with_" + component.name();
    return automaton.function(name).isPresent() ? name + "_" : name;
  }

  /** Whether the changes of an action are hard to see among the components that stay. */
  private boolean isLarge() {
    return automaton.state().size() > MOST_REPEATED;
  }

  /** Those that actions change. */
  private List<Component> changing() {
    Set<String> changed =
        automaton.actions().stream()
            .flatMap(action -> action.eff().stream())
            .map(AutomatonWriter::changedBy)
            .collect(Collectors.toSet());
    return automaton.state().stream().filter(c -> isLarge() && changed.contains(c.name())).toList();
  }

  private static String changedBy(Effect effect) {
    return switch (effect) {
      case Effect.Assign assign -> assign.component();
      case Effect.Step step -> step.used();
    };
  }

  private boolean isPartial(Effect effect) {
    return effect instanceof Effect.Step
        || effect.parts().stream().anyMatch(each -> Functions.isPartial(automaton, each));
  }

  /** The state of a used automaton after its step, which must be enabled. */
  private static Code step(Effect.Step step, Code before, ExpressionWriter writer) {
    Code after =
        writer.told(
            "step",
            step.pos(),
            Code.string(step.used()),
            Code.name(ExpressionWriter.machine(step.used())),
            writer.step(step.automaton(), step.action(), step.arguments()),
            before);
    return step.condition().map(when -> Code.choice(writer.of(when), after, before)).orElse(after);
  }

  /** {@code after}, the state after an action that must not change one place to two values. */
  private static Code once(Action action, Code after, ExpressionWriter writer) {
    Code checked = after;
    for (int i = action.eff().size() - 1; i > 0; i--) {
      Effect later = action.eff().get(i);
      for (Effect earlier : action.eff().subList(0, i)) {
        Expr differs = differs(earlier, later);
        if (!(differs instanceof Expr.Bool never && !never.value())) {
          Code isTwice = Code.and(writer.of(differs), Code.name(IS_ENABLED));
          checked = writer.told("once", later.pos(), isTwice, Code.string(action.name()), checked);
        }
      }
    }
    return checked;
  }

  /** Whether two effects change one place to two values; or take two steps of a used automaton. */
  private static Expr differs(Effect earlier, Effect later) {
    if (earlier instanceof Effect.Step one
        && later instanceof Effect.Step other
        && one.used().equals(other.used())) {
      return Exprs.all(
          Stream.of(one.condition(), other.condition()).flatMap(Optional::stream).toList(),
          other.pos());
    }
    return earlier instanceof Effect.Assign one && later instanceof Effect.Assign other
        ? differs(one, other)
        : new Expr.Bool(false, later.pos());
  }

  private static Expr differs(Effect.Assign one, Effect.Assign other) {
    Pos pos = other.pos();
    Expr never = new Expr.Bool(false, pos);
    if (!one.component().equals(other.component())) {
      return never;
    }
    List<Expr> all = new ArrayList<>();
    int common = Math.min(one.selectors().size(), other.selectors().size());
    for (int i = 0; i < common; i++) {
      if (one.selectors().get(i) instanceof Selector.At a
          && other.selectors().get(i) instanceof Selector.At b) {
        for (int k = 0; k < a.arguments().size(); k++) {
          all.add(compared(Expr.Operator.EQUAL, a.arguments().get(k), b.arguments().get(k), pos));
        }
      } else if (!one.selectors().get(i).equals(other.selectors().get(i))) {
        return never;
      }
    }
    if (one.selectors().size() == other.selectors().size()) {
      all.add(compared(Expr.Operator.UNEQUAL, one.value(), other.value(), pos));
    }
    return Exprs.all(all, pos);
  }

  private static Expr compared(Expr.Operator operator, Expr left, Expr right, Pos pos) {
    return new Expr.Binary(operator, left, right, Type.Bool.BOOL, pos);
  }

  /** {@code of} with {@code value} in the place of a part. */
  private Code changed(
      Code of, Type type, List<Selector> selectors, Code value, ExpressionWriter writer) {
    if (selectors.isEmpty()) {
      return value;
    }
    List<Selector> rest = selectors.subList(1, selectors.size());
    return switch (selectors.getFirst()) {
      case Selector.At at -> {
        Type result = ((Type.MapOf) type.base()).result();
        List<Code> arguments = at.arguments().stream().map(writer::of).toList();
        List<Code> maps = new ArrayList<>(List.of(of));
        arguments.forEach(each -> maps.add(maps.getLast().then("at", each)));
        Code whole = changed(maps.getLast(), result, rest, value, writer);
        for (int i = arguments.size() - 1; i >= 0; i--) {
          whole = maps.get(i).then("with", arguments.get(i), whole);
        }
        yield whole;
      }
      case Selector.Of field -> {
        Type.Rec rec = (Type.Rec) type.base();
        List<Code> parts = new ArrayList<>();
        for (Field each : rec.fields()) {
          Code part = of.then(JavaTypes.name(each.name()));
          parts.add(
              each.name().equals(field.field())
                  ? changed(part, each.type(), rest, value, writer)
                  : part);
        }
        yield new Code.New(types.of(type, automaton.pos()), List.copyOf(parts));
      }
    };
  }

  private ExpressionWriter writer(Action action) {
    ExpressionWriter writer = writer("s");
    action
        .parameters()
        .forEach(p -> writer.bind(p.name(), Code.name("a").then(JavaTypes.name(p.name()))));
    return writer;
  }

  private void cases(Function<Action, Code> value) {
    out.line(4, "return switch (action) {");
    for (Action action : automaton.actions()) {
      out.of(6, names.action() + "." + types.type(action.name()) + " a", value.apply(action));
    }
    out.line(4, "};").line(2, "}");
  }
}
