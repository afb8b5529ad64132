package org.starl.lang.java;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Component;
import org.starl.lang.tree.Automaton.JavaType;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Program;
import org.starl.lang.tree.Program.Branch;
import org.starl.lang.tree.Program.Instance;
import org.starl.lang.tree.Program.JavaFunction;
import org.starl.lang.tree.Program.Location;
import org.starl.lang.tree.Program.Statement;
import org.starl.lang.tree.Program.Variable;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/** Writes the {@code LogicThread} of a program, in the manner of the paper's Figure 4. */
final class ProgramWriter {

  /** Names of the generated class's own fields. */
  private static final Set<String> OWN = Set.of("gvh", "location", "line");

  private static final Type IDS = new Type.Opaque(Program.IDS);
  private static final Pattern CLASS = Pattern.compile("\\b(?:[a-z]\\w*\\.)+[A-Z]\\w*");
  private static final Pattern CALL =
      Pattern.compile("([\\w.]+)\\(([^()]*(?:\\([^()]*\\)[^()]*)*)\\)");
  // Commas that are in no parentheses.
  private static final Pattern ARGUMENTS = Pattern.compile(", *(?![^(]*\\))");
  private static final Pattern COMPARED = Pattern.compile("(.+) (==|!=) (.+)");

  private final Program program;
  private final String file;
  private final Automaton around;
  private final JavaTypes types;
  private final ExpressionWriter expressions;
  private final JavaText out = new JavaText();

  /**
   * @param file the name of the source, which waits name
   */
  ProgramWriter(Program program, String file, Names names) {
    this.program = program;
    this.file = file;
    around = around(program);
    types = new JavaTypes(around, names, false);
    expressions = new ExpressionWriter(around, types, file, this::read);
    expressions.bind(Program.SELF, Code.name("gvh.id.name()"));
  }

  JavaTypes types() {
    return types;
  }

  /** Where the program's types and functions are known. */
  private static Automaton around(Program program) {
    Map<Type, JavaType> javaTypes = new LinkedHashMap<>(program.javaTypes());
    javaTypes.putIfAbsent(IDS, new JavaType("org.starl.id.RobotId", ""));
    javaTypes.putIfAbsent(new Type.SetOf(IDS), new JavaType("org.starl.id.Participants", "of()"));
    List<Component> state = new ArrayList<>();
    program
        .variables()
        .forEach(each -> state.add(new Component(each.name(), each.type(), List.of(), "")));
    return new Automaton(
        program.name(),
        program.typeParameters(),
        program.given(),
        List.of(),
        List.of(),
        program.types(),
        List.copyOf(state),
        Map.of(),
        program.functions(),
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        program.javaClass(),
        javaTypes,
        program.comment(),
        program.pos());
  }

  String body() {
    List<String> about = program.comment().isEmpty() ? List.of("A program.") : program.comment();
    out.doc(0, about, List.of());
    String thread = types.use("org.starl.LogicThread");
    out.line(0, "public final class " + simpleName() + " extends " + thread + " {").blank();
    locations();
    new TypesWriter(around, types, out).write();
    variables();
    fields();
    constructor();
    callStarL();
    restart();
    program.functions().forEach(this::function);
    return out.line(0, "}").toString();
  }

  private String simpleName() {
    return program.javaClass().substring(program.javaClass().lastIndexOf('.') + 1);
  }

  private static String constant(String location) {
    return location.toUpperCase(Locale.ROOT);
  }

  private void locations() {
    refuseEqualNames();
    out.doc(2, List.of("The locations, with their lines in " + file + "."), List.of());
    out.line(2, "public enum Location {");
    List<Location> all = program.locations();
    for (int i = 0; i < all.size(); i++) {
      boolean isLast = i == all.size() - 1;
      String name = constant(all.get(i).name());
      out.line(4, name + "(" + all.get(i).pos().line() + ")" + (isLast ? ";" : ","));
    }
    out.blank().line(4, "private final int line;").blank();
    out.line(4, "Location(int line) {").line(6, "this.line = line;").line(4, "}").line(2, "}");
  }

  private void refuseEqualNames() {
    Map<String, String> names = new LinkedHashMap<>();
    for (Location each : program.locations()) {
      String other = names.putIfAbsent(constant(each.name()), each.name());
      if (other != null) {
        throw new NotExecutable(
            each.pos(),
            "'"
                + each.name()
                + "' and '"
                + other
                + "' have one name in Java; expected names that differ in more than the size of"
                + " letters");
      }
    }
  }

  /** A constant for each variable: observers read it under this one. */
  private void variables() {
    String var = types.use("org.starl.trace.Var");
    out.blank().doc(2, List.of("Where it is."), List.of());
    assign(
        2,
        "public static final " + var + "<Location> LOCATION",
        Code.call(var + ".of", Code.string("location"), Code.name("Location.class")));
    for (Variable each : program.variables()) {
      String type = types.boxed(each.type(), each.pos());
      String note = each.note().strip();
      out.blank()
          .doc(2, List.of(note.isEmpty() ? "The variable " + each.name() + "." : note), List.of());
      assign(
          2,
          "public static final " + var + "<" + type + "> " + declaration(each),
          Code.call(var + ".of", Code.string(each.name()), types.shape(each.type(), each.pos())));
    }
  }

  private static String declaration(Variable variable) {
    String name = constant(variable.name());
    return OWN.contains(variable.name().toLowerCase(Locale.ROOT)) ? name + "_" : name;
  }

  private void fields() {
    out.blank();
    for (Field each : kept()) {
      out.line(2, "private final " + type(each.type()) + " " + name(each.name()) + ";");
    }
    for (Instance each : program.instances()) {
      String type = types.use(each.primitive().javaType());
      out.line(2, "private final " + type + " " + name(each.name()) + ";");
    }
    String cell = types.use("org.starl.gvh.GvhCell");
    out.line(2, "private final " + cell + "<Location> location;");
    for (Variable each : program.variables()) {
      String type = types.boxed(each.type(), each.pos());
      about(each);
      out.line(2, "private final " + cell + "<" + type + "> " + name(each.name()) + ";");
    }
    out.line(2, "// of the branch that it takes, or else of its location, in " + file);
    out.line(2, "private int line;");
  }

  private void about(Variable variable) {
    Stream.concat(variable.comment().stream(), Stream.of(variable.note()))
        .filter(line -> !line.isBlank())
        .forEach(line -> out.line(2, "// " + line.strip()));
  }

  /** What is given and is read after the start. */
  private List<Field> kept() {
    Predicate<String> isRead =
        name ->
            program.locations().stream()
                    .flatMap(each -> each.branches().stream())
                    .flatMap(ProgramWriter::expressions)
                    .anyMatch(each -> mentions(each, name))
                || (restarts()
                    && program.variables().stream().anyMatch(each -> mentions(each.start(), name)));
    return program.given().stream().filter(each -> isRead.test(each.name())).toList();
  }

  private static boolean mentions(Expr at, String given) {
    return (at instanceof Expr.Parameter parameter && parameter.name().equals(given))
        || Exprs.parts(at).stream().anyMatch(part -> mentions(part, given));
  }

  private static Stream<Expr> expressions(Branch branch) {
    return Stream.concat(
        Stream.of(branch.guard()),
        branch.statements().stream()
            .flatMap(each ->
                switch (each) {
                  case Statement.Assign assign -> Stream.of(assign.value());
                  case Statement.Call call -> call.arguments().stream();
                }));
  }

  private boolean restarts() {
    return program.locations().stream()
        .anyMatch(each -> each.branches().stream().anyMatch(Branch::isRestart));
  }

  private void constructor() {
    List<String> parameters = new ArrayList<>();
    parameters.add(types.use("org.starl.GlobalVarHolder") + " gvh");
    program.given().forEach(each -> parameters.add(type(each.type()) + " " + name(each.name())));
    out.blank().head(2, "public " + simpleName(), parameters, List.of(" {"));
    out.line(4, "super(gvh);");
    kept()
        .forEach(
            each -> out.line(4, "this." + name(each.name()) + " = " + name(each.name()) + ";"));
    for (Instance each : program.instances()) {
      Map<String, Code> arguments = arguments(each.primitive().parameters(), each.arguments());
      assign(name(each.name()), java("", each.primitive().javaMade(), arguments));
    }
    variable("location", "LOCATION", Code.name("Location").field(first()));
    program
        .variables()
        .forEach(
            each -> variable(name(each.name()), declaration(each), expressions.of(each.start())));
    String wait = types.use("org.starl.gvh.Wait");
    types.use("java.util.List");
    String instance = types.use("org.starl.trace.Instance");
    String made = "new " + wait + "(" + instance + ".APP, where(), List.of())";
    out.line(4, "gvh.explain(() -> isOver() ? null : " + made + ");");
    out.line(2, "}");
  }

  private String first() {
    return constant(program.locations().getFirst().name());
  }

  private void variable(String field, String declaration, Code start) {
    assign(field, Code.call("gvh.variable", Code.name(declaration), start));
  }

  private void assign(String field, Code value) {
    assign(4, field, value);
  }

  private void assign(int indent, String target, Code value) {
    Layout layout = new Layout().token(target + " =").open(4).brk(" ");
    value.write(layout);
    out.add(indent, layout.token(";").close());
  }

  private void callStarL() {
    out.blank().line(2, "@Override").line(2, "public List<Object> callStarL() {");
    out.line(4, "while (!isOver()) {").line(6, "line = location.get().line;");
    out.line(6, "switch (location.get()) {");
    for (Location each : program.locations()) {
      each.comment().forEach(line -> out.line(8, "// " + line.strip()));
      if (each.branches().isEmpty()) {
        String error = "throw new IllegalStateException(\"the program has ended\");";
        out.line(8, "case " + constant(each.name()) + " -> " + error);
      } else {
        out.line(8, "case " + constant(each.name()) + " -> {");
        branches(each);
        out.line(8, "}");
      }
    }
    out.line(6, "}").line(6, "sleep(" + program.everyMs() + ");").line(4, "}");
    out.line(4, "return List.of();").line(2, "}");
    end();
    out.blank()
        .doc(2, List.of("Where it is, for people who ask why a run does not end."), List.of());
    out.line(2, "private String where() {");
    Code line = Code.call("location.get").field("line");
    Code where = Code.infix("+", Code.call("location.get"), Code.string(", " + file + ":"), line);
    out.returned(4, where).line(2, "}");
    Code made =
        new Code.New(
            "StackTraceElement",
            List.of(
                Code.call("getClass").then("getName"),
                Code.string("callStarL"),
                Code.string(file),
                Code.name("line")));
    out.blank().line(2, "@Override").line(2, "protected StackTraceElement inSource() {");
    out.returned(4, made).line(2, "}");
  }

  private void end() {
    List<Code> ends =
        program.locations().stream()
            .filter(each -> each.branches().isEmpty())
            .map(each ->
                Code.infix(
                    "==",
                    Code.call("location.get"),
                    Code.name("Location").field(constant(each.name()))))
            .toList();
    out.blank().line(2, "private boolean isOver() {");
    out.returned(4, ends.stream().reduce(Code.Text.FALSE, Code::or)).line(2, "}");
  }

  private void branches(Location location) {
    String before = "";
    for (Branch branch : location.branches()) {
      Code guard = expressions.of(branch.guard());
      boolean isAlways = guard.equals(Code.Text.TRUE);
      int indent = isAlways && before.isEmpty() ? 10 : 12;
      if (isAlways && !before.isEmpty()) {
        out.line(10, before + "{");
      } else if (!isAlways) {
        Layout layout = new Layout().token(before + "if (");
        guard.write(layout);
        out.add(10, layout.token(") {"));
      }
      out.line(indent, "line = " + branch.pos().line() + ";");
      branch.statements().forEach(each -> statement(indent, each));
      if (branch.isRestart()) {
        out.line(indent, "restart();");
      } else if (!branch.to().equals(location.name())) {
        out.line(indent, "location.set(Location." + constant(branch.to()) + ");");
      }
      before = indent == 10 ? "" : "} else ";
    }
    if (!before.isEmpty()) {
      out.line(10, "}");
    }
  }

  private void statement(int indent, Statement at) {
    Code code =
        switch (at) {
          case Statement.Assign assign ->
              Code.name(name(assign.variable())).then("set", expressions.of(assign.value()));
          case Statement.Call call ->
              java(
                  name(call.instance()) + ".",
                  call.call().java(),
                  arguments(call.call().parameters(), call.arguments()));
        };
    Layout layout = new Layout();
    code.write(layout);
    out.add(indent, layout.token(";"));
  }

  private void restart() {
    if (restarts()) {
      out.blank().doc(2, List.of("Begins anew."), List.of()).line(2, "private void restart() {");
      for (Variable each : program.variables()) {
        statement(4, new Statement.Assign(each.name(), each.start(), "", each.pos()));
      }
      out.line(4, "location.set(Location." + first() + ");").line(2, "}");
    }
  }

  private void function(org.starl.lang.tree.Function f) {
    List<String> parameters = new ArrayList<>();
    for (Field each : f.signature().parameters()) {
      parameters.add(type(each.type()) + " " + JavaTypes.variable(each.name()));
      expressions.bind(each.name(), Code.name(JavaTypes.variable(each.name())));
    }
    String head = type(f.signature().result()) + " " + JavaTypes.function(f.signature().name());
    out.blank().doc(2, f.comment(), List.of());
    out.head(2, "private " + head, parameters, List.of(" {"));
    out.returned(4, expressions.of(f.body())).line(2, "}");
  }

  // --- names of the program
  // ------------------------------------------------------------------------

  private static String name(String name) {
    return OWN.contains(name) ? name + "_" : JavaTypes.name(name);
  }

  private String type(Type type) {
    return types.of(type, program.pos());
  }

  /** The Java of what only programs have: variables of the gvh, primitives, and functions in Java. */
  private @Nullable Code read(Expr at) {
    if (at instanceof Expr.Component variable) {
      return Code.name(name(variable.name())).then("get");
    }
    if (at instanceof Expr.Get get && get.of() instanceof Expr.Component of) {
      Optional<Instance> instance = program.instance(of.name());
      if (instance.isPresent()) {
        return java(name(of.name()) + ".", javaOf(instance.get(), get.field()), Map.of());
      }
    }
    if (at instanceof Expr.At call && call.map() instanceof Expr.Parameter called) {
      Optional<JavaFunction> function = javaFunction(called.name());
      if (function.isPresent()) {
        List<Code> arguments = call.arguments().stream().map(expressions::of).toList();
        return java(function.get(), arguments);
      }
    }
    return at instanceof Expr.Parameter constant
        ? javaFunction(constant.name()).map(each -> java(each, List.of())).orElse(null)
        : null;
  }

  private Optional<JavaFunction> javaFunction(String name) {
    return program.javaFunctions().stream().filter(each -> each.name().equals(name)).findFirst();
  }

  private Code java(JavaFunction function, List<Code> arguments) {
    int dot = function.method().lastIndexOf('.');
    String owner = types.use(function.method().substring(0, dot));
    return Code.call(owner + function.method().substring(dot), arguments.toArray(Code[]::new));
  }

  private static String javaOf(Instance instance, String field) {
    return instance
        .primitive()
        .value(field)
        .map(each -> each.java())
        .or(() -> instance.primitive().outcome(field).map(each -> each.java()))
        .orElseThrow();
  }

  private Map<String, Code> arguments(List<Field> parameters, List<Expr> values) {
    Map<String, Code> arguments = new LinkedHashMap<>();
    for (int i = 0; i < values.size(); i++) {
      Expr value = values.get(i);
      // An instance that another one is made of is itself, and no variable of the gvh.
      boolean isInstance =
          value instanceof Expr.Component of && program.instance(of.name()).isPresent();
      arguments.put(
          parameters.get(i).name(),
          isInstance ? Code.name(name(((Expr.Component) value).name())) : expressions.of(value));
    }
    return arguments;
  }

  /** A primitive's Java text: a comparison, a call, or a name; full names of classes are imported. */
  private Code java(String before, String text, Map<String, Code> arguments) {
    String plain =
        CLASS.matcher(text).replaceAll(full -> Matcher.quoteReplacement(types.use(full.group())));
    Matcher compared = COMPARED.matcher(plain);
    if (compared.matches()) {
      return Code.infix(
          compared.group(2),
          java(before, compared.group(1), arguments),
          Code.name(compared.group(3)));
    }
    boolean isNew = plain.startsWith("new ");
    Matcher call = CALL.matcher(isNew ? plain.substring(4) : plain);
    if (!call.matches()) {
      return Code.name(before + plain);
    }
    List<Code> all = new ArrayList<>();
    for (String each : ARGUMENTS.split(call.group(2), -1)) {
      if (!each.isEmpty()) {
        Code given = arguments.get(each);
        all.add(given != null ? given : java("", each, arguments));
      }
    }
    return isNew
        ? new Code.New(call.group(1), all)
        : Code.call(before + call.group(1), all.toArray(Code[]::new));
  }
}
