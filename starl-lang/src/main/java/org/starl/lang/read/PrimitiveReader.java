package org.starl.lang.read;

import static org.starl.lang.read.Problems.pos;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.starl.lang.grammar.StarlParser;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Primitive;
import org.starl.lang.tree.Program;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/** Reads a primitive: how programs use it, in the names of the automaton behind it. */
final class PrimitiveReader extends PartsReader {

  private final StarlParser.PrimitiveContext unit;
  private final java.util.function.Function<String, Optional<Automaton>> automata;
  private final List<Primitive.Call> calls = new ArrayList<>();
  private final List<Primitive.Value> values = new ArrayList<>();
  private final List<Primitive.Outcome> outcomes = new ArrayList<>();
  private final List<Primitive.Step> steps = new ArrayList<>();
  private final ProgressReader assumed = new ProgressReader(this);
  private String javaType = "";
  private String javaMade = "";
  private Expr start;
  private Expr rest;

  /**
   * @param automata finds automata
   * @param before primitives whose instances it may be made of
   */
  PrimitiveReader(
      StarlParser.PrimitiveContext unit,
      SourceText source,
      Problems problems,
      java.util.function.Function<String, Optional<Automaton>> automata,
      List<Primitive> before) {
    super(unit, unit.name.getText(), List.of(), source, problems);
    this.unit = unit;
    this.automata = automata;
    start = new Expr.Bool(true, pos(unit));
    rest = start;
    scope.types.put(Program.TEXT, new Type.Opaque(Program.TEXT));
    before.forEach(each -> scope.types.put(each.name(), each.type()));
  }

  /** Its result is complete only if no problem was told; empty if its automaton is not known. */
  Optional<Primitive> read() {
    List<Primitive> made = new ArrayList<>();
    orTold(() -> made.add(primitive()));
    return made.stream().findFirst();
  }

  private Primitive primitive() {
    String wanted = unit.of.getText();
    Automaton automaton =
        automata
            .apply(wanted)
            .orElseThrow(() ->
                expressions.wrong(
                    unit.of,
                    "automaton '"
                        + wanted
                        + "' is not known; expected it before this primitive, in "
                        + wanted
                        + ".starl beside this file, or one of StarL's own"));
    scope.enter(automaton);
    Field self = new Field(Program.SELF, new Type.Opaque(Program.IDS));
    scope.push(List.of(self));
    List<Field> parameters = fields(unit.binders(), true);
    unit.face().forEach(face -> orTold(() -> read(face, automaton)));
    return new Primitive(
        unit.name.getText(),
        parameters,
        automaton,
        List.copyOf(calls),
        List.copyOf(values),
        List.copyOf(outcomes),
        List.copyOf(steps),
        List.copyOf(assumed.all),
        start,
        rest,
        javaType,
        javaMade,
        source.before(unit),
        pos(unit));
  }

  private boolean read(StarlParser.FaceContext face, Automaton automaton) {
    return switch (face) {
      case StarlParser.JavaFaceContext at -> {
        javaType = unquoted(at.of);
        javaMade = unquoted(at.made);
        yield true;
      }
      case StarlParser.CallFaceContext at -> {
        List<Field> parameters = fields(at.binders(), true);
        scope.push(parameters);
        try {
          List<Expr> pre =
              at.pre() == null
                  ? List.of()
                  : at.pre().expression().stream().map(expressions::bool).toList();
          Action action = action(at.usedStep().action, automaton);
          List<Expr> arguments = arguments(at.usedStep(), action);
          yield calls.add(
              new Primitive.Call(
                  at.name.getText(), parameters, pre, action, arguments, unquoted(at.of)));
        } finally {
          scope.pop(parameters);
        }
      }
      case StarlParser.ValueFaceContext at -> {
        Type type = types.type(at.type());
        Expr value = expressions.read(at.expression(), type);
        yield values.add(new Primitive.Value(at.name.getText(), type, value, unquoted(at.of)));
      }
      case StarlParser.OutcomeFaceContext at -> {
        Action action = action(at.usedStep().action, automaton);
        List<Expr> arguments = arguments(at.usedStep(), action);
        yield outcomes.add(
            new Primitive.Outcome(at.name.getText(), action, arguments, unquoted(at.of)));
      }
      case StarlParser.StepsFaceContext at -> {
        at.id().forEach(id -> orTold(() -> steps.add(step(id, at.fairness(), automaton))));
        yield true;
      }
      case StarlParser.AssumedFaceContext at -> {
        assumed.read(at, at.name, true, at.formula());
        yield true;
      }
      case StarlParser.StartFaceContext at -> {
        start = expressions.bool(at.expression());
        yield true;
      }
      case StarlParser.RestFaceContext at -> {
        rest = expressions.bool(at.expression());
        yield true;
      }
      default -> throw new IllegalStateException(face.getText());
    };
  }

  private Primitive.Step step(
      StarlParser.IdContext id,
      StarlParser.@Nullable FairnessContext fairness,
      Automaton automaton) {
    Action action = action(id, automaton);
    return new Primitive.Step(
        action, Optional.ofNullable(fairness).map(at -> fairness(at, id, action.parameters())));
  }

  private List<Expr> arguments(StarlParser.UsedStepContext at, Action action) {
    return expressions.arguments(action.name(), action.parameters(), at.expression(), at);
  }
}
