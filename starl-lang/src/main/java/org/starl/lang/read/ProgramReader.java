package org.starl.lang.read;

import static org.starl.lang.read.Problems.pos;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import org.starl.lang.grammar.StarlParser;
import org.starl.lang.grammar.StarlParser.PartContext;
import org.starl.lang.grammar.StarlParser.ProgramPartContext;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Function;
import org.starl.lang.tree.Primitive;
import org.starl.lang.tree.Program;
import org.starl.lang.tree.Program.Instance;
import org.starl.lang.tree.Program.JavaFunction;
import org.starl.lang.tree.Program.Location;
import org.starl.lang.tree.Program.Variable;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/** Reads one program, and makes the automaton of all processes that run it. */
final class ProgramReader extends PartsReader {

  private static final int USUAL_EVERY_MS = 100;
  private static final Pattern METHOD = Pattern.compile("(\\w+\\.)+\\w+");

  private final StarlParser.ProgramContext unit;
  private final List<Primitive> primitives;
  private final Set<String> typeParameters = new LinkedHashSet<>();
  private final List<JavaFunction> javaFunctions = new ArrayList<>();
  private final List<Field> given = new ArrayList<>();
  private final Map<String, Instance> instances = new LinkedHashMap<>();
  private final List<Variable> variables = new ArrayList<>();
  private int everyMs = USUAL_EVERY_MS;
  private boolean hasEvery;

  /**
   * @param primitives those that it may use
   */
  ProgramReader(
      StarlParser.ProgramContext unit,
      SourceText source,
      Problems problems,
      List<Primitive> primitives) {
    super(unit, unit.name.getText(), parts(unit), source, problems);
    this.unit = unit;
    this.primitives = primitives;
    scope.types.put(Program.TEXT, new Type.Opaque(Program.TEXT));
  }

  private static List<PartContext> parts(StarlParser.ProgramContext unit) {
    return unit.programPart().stream()
        .filter(StarlParser.OtherPartContext.class::isInstance)
        .map(part -> ((StarlParser.OtherPartContext) part).part())
        .toList();
  }

  /** Its result is complete only if no problem was told. */
  Program read() {
    refuseOthers();
    readTypeParameters();
    readTypes();
    scope.types.remove(Lowering.LOCATION); // was there so that no type has this name
    every(StarlParser.JavaFunPartContext.class, this::javaFunction);
    scope.push(List.of(new Field(Program.SELF, new Type.Opaque(Program.IDS))));
    List<Function> functions = functions();
    every(StarlParser.GivenPartContext.class, at -> at.given().forEach(this::given));
    every(StarlParser.VariablesPartContext.class, at -> at.variable().forEach(this::variable));
    every(StarlParser.InstancePartContext.class, this::instance);
    variables.forEach(each -> scope.state.put(each.name(), each.type()));
    every(StarlParser.EveryPartContext.class, this::every);
    readJava();
    List<Location> locations = new LocationsReader(this, instances).read(locationParts());
    return new Program(
        scope.automaton,
        List.copyOf(typeParameters),
        List.copyOf(declared),
        List.copyOf(given),
        List.copyOf(javaFunctions),
        functions,
        List.copyOf(instances.values()),
        List.copyOf(variables),
        everyMs,
        locations,
        javaClass,
        Collections.unmodifiableMap(javaTypes),
        source.before(unit),
        pos(unit));
  }

  /** The automaton of all processes, with the invariants and the progress of the source. */
  Automaton automaton(Program program) {
    boolean asks = parts(unit).stream().anyMatch(StarlParser.ProgressPartContext.class::isInstance);
    Lowering lowering = new Lowering(program, asks);
    PartsReader all = new PartsReader(unit, scope.automaton, parts(unit), source, problems);
    ProgressReader progress = new ProgressReader(all);
    all.scope.enter(lowering.automaton(List.of(), List.of(), progress, false));
    all.scope.places.putAll(scope.places);
    List<Invariant> invariants = all.invariants();
    progress.read(invariants);
    return lowering.automaton(invariants, all.constraints(), progress, true);
  }

  private <P extends ProgramPartContext> void every(Class<P> kind, Consumer<P> read) {
    each(unit.programPart(), kind, read);
  }

  private List<StarlParser.LocationPartContext> locationParts() {
    List<StarlParser.LocationPartContext> parts = new ArrayList<>();
    every(StarlParser.LocationPartContext.class, parts::add);
    return parts;
  }

  private void refuseOthers() {
    for (PartContext part : parts(unit)) {
      String expected =
          switch (part) {
            case StarlParser.UsesPartContext at -> {
              scope.wrong.add(at.name.getText());
              yield "'uses NAME: PRIMITIVE(...)'";
            }
            case StarlParser.StartPartContext at -> "a start value with each variable: 'x: T := e'";
            case StarlParser.ActionPartContext at -> "'location' and its branches";
            case StarlParser.RefinesPartContext at -> "an invariant";
            case StarlParser.AssumePartContext at -> "a guard: 'when condition do ...'";
            default -> "";
          };
      if (!expected.isEmpty()) {
        problems.add(
            part,
            "'" + part.getStart().getText() + "' is for automata; expected " + expected + " here");
      }
    }
  }

  /** Those of the source, and those of the primitives, whose types are known by their names. */
  private void readTypeParameters() {
    addOpaque(Program.IDS);
    if (unit.parameters() != null) {
      for (StarlParser.ParameterContext parameter : unit.parameters().parameter()) {
        if (parameter instanceof StarlParser.TypeParameterContext type) {
          if (type.name.getText().equals(Program.IDS)) {
            scope.types.remove(Program.IDS);
          }
          addOpaque(newName(type.name));
        } else {
          problems.add(parameter, "a program has no value parameters; expected 'given' after this");
        }
      }
    }
    for (ProgramPartContext part : unit.programPart()) {
      if (part instanceof StarlParser.InstancePartContext at) {
        primitive(at.of.getText())
            .map(Primitive::automaton)
            .ifPresent(each -> {
              enter(each);
              scope.knowTypes(each);
            });
      }
    }
    scope.types.put(Lowering.LOCATION, new Type.Opaque(Lowering.LOCATION));
  }

  private void addOpaque(String name) {
    typeParameters.add(name);
    scope.types.putIfAbsent(name, new Type.Opaque(name));
  }

  private void enter(Automaton automaton) {
    automaton.typeParameters().forEach(this::addOpaque);
    automaton.valueParameters().forEach(each -> scope.values.put(each.name(), each.type()));
    automaton.uses().values().forEach(this::enter);
  }

  private Optional<Primitive> primitive(String name) {
    return primitives.stream().filter(each -> each.name().equals(name)).findFirst();
  }

  /** A name that is new, and not one of the automaton that is made of the program. */
  String freshName(StarlParser.IdContext at) {
    String name = newName(at);
    if (Lowering.NAMES.contains(name)) {
      problems.add(
          at, "'" + name + "' is a name in the automaton of each program; expected another name");
    }
    return name;
  }

  private void javaFunction(StarlParser.JavaFunPartContext at) {
    String name = freshName(at.name);
    List<Field> parameters = scope.declaring(name, () -> fields(at.binders(), true));
    Type result = scope.declaring(name, () -> types.type(at.type()));
    String method = unquoted(at.of);
    if (!METHOD.matcher(method).matches()) {
      problems.add(
          pos(at.of), "'" + method + "' is no method of Java; expected \"a.package.Class.method\"");
    }
    List<Type> arguments = parameters.stream().map(Field::type).toList();
    scope.values.put(name, arguments.isEmpty() ? result : new Type.MapOf(arguments, result));
    javaFunctions.add(new JavaFunction(name, parameters, result, method, pos(at)));
  }

  private void given(StarlParser.GivenContext at) {
    String name = freshName(at.name);
    Field field = new Field(name, scope.declaring(name, () -> types.type(at.type())));
    scope.values.put(field.name(), field.type());
    given.add(field);
  }

  /** Start values are read while no variable is known. */
  private void variable(StarlParser.VariableContext at) {
    orTold(() -> {
      String name = freshName(at.name);
      return variables.add(scope.declaring(name, () -> variable(name, at)));
    });
  }

  private Variable variable(String name, StarlParser.VariableContext at) {
    Type type = types.type(at.type());
    if (at.expression() == null) {
      throw expressions.wrong(
          at, "variable '" + name + "' has no start value; expected ':=' and a value of " + type);
    }
    Expr start = expressions.read(at.expression(), type);
    return new Variable(name, type, start, source.before(at), source.after(at.getStop()), pos(at));
  }

  private void instance(StarlParser.InstancePartContext at) {
    String name = freshName(at.name);
    Instance instance = scope.declaring(name, () -> instance(name, at));
    scope.state.put(name, instance.primitive().type());
    instances.put(name, instance);
  }

  private Instance instance(String name, StarlParser.InstancePartContext at) {
    Primitive primitive =
        primitive(at.of.getText())
            .orElseThrow(() -> {
              List<String> known = primitives.stream().map(Primitive::name).toList();
              String wanted = at.of.getText();
              return expressions.wrong(
                  at.of, "'" + wanted + "' is no primitive; " + Problems.oneOf(wanted, known));
            });
    problems.refer(
        at.of,
        "primitive %s(%s) is %s"
            .formatted(
                primitive.name(),
                TypeReader.list(primitive.parameters()),
                primitive.automaton().name()),
        pos(at.of));
    List<Expr> arguments =
        expressions.arguments(primitive.name(), primitive.parameters(), at.expression(), at);
    return new Instance(name, primitive, arguments, source.before(at), pos(at));
  }

  private void every(StarlParser.EveryPartContext at) {
    if (hasEvery) {
      problems.add(at, "'every' is here twice; expected it once");
    }
    hasEvery = true;
    String number = at.NUMBER().getText();
    boolean isWhole = number.matches("[1-9][0-9]{0,4}");
    if (!isWhole || !at.unitOfTime.getText().equals("ms")) {
      throw expressions.wrong(
          at,
          "'%s %s' is no such time; expected a whole number from 1 to 99999, and 'ms'"
              .formatted(number, at.unitOfTime.getText()));
    }
    everyMs = Integer.parseInt(number);
  }
}
