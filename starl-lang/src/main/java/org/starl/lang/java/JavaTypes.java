package org.starl.lang.java;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.lang.model.SourceVersion;
import org.jspecify.annotations.Nullable;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.JavaType;
import org.starl.lang.tree.Bound;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Type;

/** The Java types of an automaton's types, and names that Java allows. */
final class JavaTypes {

  private static final String FUN = "org.starl.spec.automaton.Fun";

  /** Names of the generated methods' own variables. */
  private static final Set<String> LOCAL = Set.of("s", "a", "action", "value");

  /** Names that are taken in Java, or in every generated class. */
  private static final Set<String> TAKEN =
      Set.of(
          ("abstract assert boolean break byte case catch char class const continue default do double"
                  + " else enum extends final finally float for goto if implements import instanceof"
                  + " int interface long native new package private protected public return short"
                  + " static strictfp super switch synchronized this throw throws transient try void"
                  + " volatile while true false null _ yield record sealed permits var"
                  + " args name text start theory hashCode equals toString getClass notify"
                  + " notifyAll wait clone finalize"
                  + " Action Automaton BiFunction BiPredicate Boolean Double Enabled Finite Fun"
                  + " Function Lift List Location Long Math Object Objects Override Predicate Sets"
                  + " SortedSet States String SuppressWarnings Term Undefined")
              .split(" "));

  /** Names that a module declaration reads as keywords: Error Prone warns of them. */
  private static final Set<String> CONTEXTUAL =
      Set.of(
          "exports",
          "module",
          "open",
          "opens",
          "provides",
          "requires",
          "to",
          "transitive",
          "uses",
          "when",
          "with");

  private final Map<Type, JavaType> given;

  /** Full names of the classes used so far, by simple name. */
  private final Map<String, String> imports = new TreeMap<>();

  /** Simple names of classes that the source declares. */
  private final Set<String> declared;

  private final Names names;
  private final boolean isOutside;

  /** Names of the classes of what the automaton uses, by the names of these automata. */
  private final Map<String, Names> used;

  /**
   * @param isOutside whether the file is not that of the automaton, in which its types are declared
   */
  JavaTypes(Automaton automaton, Names names, boolean isOutside) {
    this.names = names;
    this.isOutside = isOutside;
    used =
        Uses.all(automaton)
            .filter(each -> !each.javaClass().isEmpty())
            .collect(Collectors.toMap(Automaton::name, Names::of, (one, same) -> one));
    declared = declared(automaton).collect(Collectors.toUnmodifiableSet());
    automaton.javaTypes().forEach((type, java) -> requireClass(type, java, automaton.pos()));
    given =
        automaton.javaTypes().entrySet().stream()
            .collect(Collectors.toUnmodifiableMap(e -> e.getKey().base(), Map.Entry::getValue));
  }

  private static Stream<String> declared(Automaton automaton) {
    Stream<String> types =
        automaton.types().stream()
            .map(Automaton.Declared::type)
            .flatMap(each ->
                each instanceof Type.Sum sum
                    ? Stream.concat(
                        Stream.of(sum.name()),
                        sum.constructors().stream().map(Type.Constructor::name))
                    : Stream.of(each.toString()));
    return Stream.concat(types, automaton.actions().stream().map(Action::name))
        .map(JavaTypes::name);
  }

  /** Java would not compile with another name, in a place that is not of the source. */
  private static void requireClass(Type type, JavaType java, Pos pos) {
    String name = java.name();
    if (!SourceVersion.isName(name) && !name.equals("long") && !name.equals("double")) {
      throw new NotExecutable(
          pos,
          "'%s' is no class; expected one that has no parameters, as in: java %s = \"String\""
              .formatted(name, type));
    }
  }

  /** The form of sets of one type. */
  enum Sets {
    /** {@code SortedSet}: finite sets. */
    FINITE,
    /** {@code Fun<T, Boolean>}: finite sets and their complements. */
    FUN,
    /** A class with a method {@code contains}. */
    OWN
  }

  Sets form(Type set) {
    return given(set).map(own -> own.name().equals(FUN) ? Sets.FUN : Sets.OWN).orElse(Sets.FINITE);
  }

  private Optional<JavaType> given(Type type) {
    return Optional.ofNullable(given.get(type.base()));
  }

  /** Uses a class; returns its simple name, or the full one if the source declares another of it. */
  String use(String full) {
    String simple = full.substring(full.lastIndexOf('.') + 1);
    String own = names.packageName() + "." + names.automaton() + ".";
    if (declared.contains(simple) && !full.startsWith(own)) {
      return full.contains(".") ? full : "java.lang." + full;
    }
    boolean isHere = full.equals(names.packageName() + "." + simple);
    if (full.contains(".") && !isHere) {
      imports.put(simple, full);
    }
    return simple;
  }

  Iterable<String> imports() {
    return imports.values().stream().sorted().toList();
  }

  static boolean isContextual(String name) {
    return CONTEXTUAL.contains(name);
  }

  /** {@code name} as a name of Java. */
  static String name(String name) {
    String plain = name.endsWith("?") ? name.substring(0, name.length() - 1) : name;
    return TAKEN.contains(plain) ? plain + "_" : plain;
  }

  /** {@code name} as the name of a class in those of the automaton. */
  String type(String name) {
    return type(name, names);
  }

  private static String type(String name, Names names) {
    boolean isTheirs = name.equals(names.automaton()) || name.equals(names.action());
    return isTheirs ? name + "_" : name(name);
  }

  /** {@code name} as the name of a form. */
  static String form(Type.Sum sum, String name) {
    return !sum.isEnum() && name.equals(sum.name()) ? name + "_" : name(name);
  }

  /** {@code name} as the name of a variable. */
  static String variable(String name) {
    return LOCAL.contains(name) ? name + "_" : name(name);
  }

  /** {@code free_for?} is {@code isFreeFor}, {@code members} is itself. */
  static String function(String name) {
    if (!name.endsWith("?")) {
      return name(name);
    }
    StringBuilder camel = new StringBuilder("is");
    for (String word : name(name).split("_", -1)) {
      if (!word.isEmpty()) {
        camel.append(Character.toUpperCase(word.charAt(0))).append(word.substring(1));
      }
    }
    return camel.toString();
  }

  /** As the type of a variable. */
  String of(Type type, Pos pos) {
    return of(type, false, pos);
  }

  /** As an argument of a generic type. */
  String boxed(Type type, Pos pos) {
    return of(type, true, pos);
  }

  private String of(Type type, boolean isBoxed, Pos pos) {
    Optional<JavaType> own = given(type);
    if (own.isPresent() && !(type.base() instanceof Type.SetOf && form(type) == Sets.FUN)) {
      String name = use(own.get().name());
      return !isBoxed
          ? name
          : name.equals("long") ? "Long" : name.equals("double") ? "Double" : name;
    }
    return switch (type) {
      case Type.Alias alias -> of(alias.target(), isBoxed, pos);
      case Type.Bool bool -> isBoxed ? "Boolean" : "boolean";
      case Type.Num number when number.isWhole() -> isBoxed ? "Long" : "long";
      case Type.Num number ->
          throw new NotExecutable(
              pos,
              "no Java type is given for "
                  + number
                  + "; expected a line: java "
                  + number
                  + " = \"long\", or \"double\"");
      case Type.Range range -> isBoxed ? "Long" : "long";
      case Type.Opaque opaque -> "String";
      case Type.Rec rec -> declared(rec.owner(), rec.name());
      case Type.Sum sum -> declared(sum.owner(), sum.name());
      case Type.SetOf set when form(set) == Sets.FUN ->
          use(FUN) + "<" + boxed(set.element(), pos) + ", Boolean>";
      case Type.SetOf set -> use("java.util.SortedSet") + "<" + boxed(set.element(), pos) + ">";
      case Type.ListOf list -> use("java.util.List") + "<" + boxed(list.element(), pos) + ">";
      case Type.OptionOf option ->
          use("org.starl.spec.automaton.Lift") + "<" + boxed(option.element(), pos) + ">";
      case Type.MapOf map -> {
        String whole = boxed(map.result(), pos);
        for (Type argument : map.arguments().reversed()) {
          requireOrder(argument, pos);
          whole = use(FUN) + "<" + boxed(argument, pos) + ", " + whole + ">";
        }
        yield whole;
      }
      case Type.StateOf state -> automaton(state.automaton()) + ".States";
    };
  }

  /** The arguments of a map are found by their order. */
  private void requireOrder(Type argument, Pos pos) {
    Type of = argument.base();
    boolean isData = of instanceof Type.SetOf || of instanceof Type.ListOf;
    boolean hasOrder = !isData && !(of instanceof Type.OptionOf || of instanceof Type.MapOf);
    if (!hasOrder && !isGiven(argument)) {
      throw new NotExecutable(
          pos,
          "in Java a map has no arguments of type "
              + argument
              + "; expected numbers, an opaque type, a record or a type of forms");
    }
  }

  /** The class of a used automaton. */
  String automaton(Automaton of) {
    Names its = names(of);
    return use(its.packageName() + "." + its.automaton());
  }

  /** The record of an action of a used automaton. */
  String action(Automaton of, String name) {
    Names its = names(of);
    return use(its.packageName() + "." + its.action()) + "." + type(name, its);
  }

  private Names names(Automaton of) {
    return Objects.requireNonNull(used.get(of.name()), of.name());
  }

  private String declared(String owner, String name) {
    Names its = used.get(owner);
    if (its != null) {
      return use(its.packageName() + "." + its.automaton()) + "." + type(name, its);
    }
    String type = type(name);
    return isOutside ? use(names.packageName() + "." + names.automaton() + "." + type) : type;
  }

  /** Whether the type is a class that the source names, so that it is not declared. */
  boolean isGiven(Type type) {
    return given(type).isPresent();
  }

  /** A value of the type for a start state that may have any; also the empty set of a given class. */
  Code any(Type type, Pos pos) {
    Optional<JavaType> own = given(type);
    if (own.isPresent() && !own.get().start().isEmpty()) {
      return Code.name(use(own.get().name())).field(own.get().start());
    }
    return switch (type.base()) {
      case Type.Bool bool -> Code.Text.FALSE;
      case Type.Num number -> zero(number, pos);
      case Type.Range range ->
          range.low().isAtMost(Bound.of(0)) && range.high().isAtLeast(0)
              ? bound(Bound.of(0))
              : bound(range.high().isAtMost(Bound.of(-1)) ? range.high() : range.low());
      case Type.SetOf set when form(set) == Sets.FUN -> always(Code.Text.FALSE);
      case Type.SetOf set when form(set) == Sets.FINITE -> emptyset();
      case Type.ListOf list -> list();
      case Type.OptionOf option -> bottom();
      case Type.MapOf map -> {
        Code value = any(map.result(), pos);
        for (int i = 0; i < map.arguments().size(); i++) {
          value = always(value);
        }
        yield value;
      }
      case Type.Rec rec ->
          new Code.New(of(rec, pos), rec.fields().stream().map(f -> any(f.type(), pos)).toList());
      case Type.Sum sum when sum.constructors().getFirst().fields().isEmpty() ->
          make(sum, sum.constructors().getFirst().name(), List.of(), pos);
      case Type.Opaque opaque when own.isEmpty() -> Code.string("");
      case Type.StateOf state ->
          new Code.New(
              of(state, pos),
              state.automaton().state().stream().map(each -> any(each.type(), pos)).toList());
      default ->
          throw new NotExecutable(
              pos,
              "no value of "
                  + type
                  + " is given for the start state; expected a line: java "
                  + type
                  + " = \"a.Class\" start \"A_CONSTANT\"");
    };
  }

  private Code zero(Type.Num number, Pos pos) {
    return Code.name(of(number, pos).equals("double") ? "0.0" : "0L");
  }

  Code emptyset() {
    return Code.call(use("org.starl.spec.automaton.Sets") + ".emptyset");
  }

  Code always(Code value) {
    return Code.call(use(FUN) + ".always", value);
  }

  /**
   * The map that is {@code value} everywhere. What it is apart from the {@link #all} values of a type is
   * the same for all maps.
   */
  Code constant(Type.MapOf map, Code value, Pos pos) {
    Code code = value;
    Type result = map.result();
    for (Type argument : map.arguments().reversed()) {
      Code all = all(argument, pos);
      code =
          all == null || code.equals(any(result, pos))
              ? always(code)
              : Code.call(
                  use("org.starl.spec.automaton.Finite") + ".map",
                  always(any(result, pos)),
                  new Code.Lambda("each", code),
                  all);
      result = new Type.MapOf(List.of(argument), result);
    }
    return code;
  }

  /** All values of a range, of {@code bool}, or of a type of forms without fields; null of others. */
  @Nullable Code all(Type type, Pos pos) {
    return switch (type.base()) {
      case Type.Range range ->
          Code.call(
              use("org.starl.spec.automaton.Finite") + ".range",
              bound(range.low()),
              bound(range.high()));
      case Type.Bool bool -> list(Code.Text.FALSE, Code.Text.TRUE);
      case Type.Sum sum when sum.isEnum() ->
          list(
              sum.constructors().stream()
                  .map(form -> make(sum, form.name(), List.of(), pos))
                  .toArray(Code[]::new));
      default -> null;
    };
  }

  Code list(Code... elements) {
    return Code.call(use("java.util.List") + ".of", elements);
  }

  /** A bound of a range, as an argument. */
  static Code bound(Bound of) {
    return Code.name(of.text("-", JavaTypes::name, "L"));
  }

  Code bottom() {
    return new Code.New(use("org.starl.spec.automaton.Lift") + ".bottom<>", List.of());
  }

  /** A value of a sum. */
  Code make(Type.Sum sum, String constructor, List<Code> arguments, Pos pos) {
    String type = of(sum, pos);
    return sum.isEnum()
        ? Code.name(type).field(form(sum, constructor))
        : new Code.New(type + "." + form(sum, constructor), arguments);
  }

  /** How values of a type are written in a trace. */
  Code shape(Type type, Pos pos) {
    String shapes = use("org.starl.shape.Shapes");
    Code most = Code.name("0xFFFF");
    Code words = Code.call(shapes + ".words");
    return switch (type.base()) {
      case Type.SetOf set when !isGiven(set) && form(set) == Sets.FINITE ->
          shape(set.element(), pos).equals(words)
              ? words
              : Code.call(shapes + ".set", shape(set.element(), pos), most);
      case Type.ListOf list when !isGiven(list) ->
          shape(list.element(), pos).equals(words)
              ? words
              : Code.call(shapes + ".list", shape(list.element(), pos), most);
      default ->
          switch (boxed(type, pos)) {
            case "Boolean" -> Code.name(shapes + ".BOOL");
            case "Long" -> Code.name(shapes + ".LONG");
            case "Double" -> Code.name(shapes + ".REAL");
            case "String" -> Code.name(shapes + ".TEXT");
            case "RobotId" -> Code.name(shapes + ".ROBOT");
            case "ProcessId" -> Code.name(shapes + ".PROCESS");
            case "Participants" -> Code.name(shapes + ".PARTICIPANTS");
            default -> words;
          };
    };
  }
}
