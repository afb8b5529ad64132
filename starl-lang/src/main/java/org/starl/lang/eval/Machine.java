package org.starl.lang.eval;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.lang.eval.Code.Frame;
import org.starl.lang.tree.Action.Conjunct;
import org.starl.lang.tree.Action.Fairness;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Refinement;
import org.starl.lang.tree.Type.Field;

/**
 * An automaton at small sizes. Its states are rows: the values of its value parameters, which never
 * change, then of its components. Not thread-safe.
 */
public final class Machine {

  /** Is told the steps of a state. */
  public interface Steps {

    /** A step that can be taken. */
    default void step(int action, Object[] arguments, Row after) {}

    /**
     * A step whose evaluation or state is beyond the bounds, and so is left out.
     *
     * @param arguments those that were chosen; there may be fewer than parameters
     */
    default void beyond(int action, Object[] arguments) {}

    /** For some arguments this conjunct is the first one that is false. */
    default void conjunctIsFalse(int action, int conjunct) {}

    /**
     * A step, or its condition, has no value.
     *
     * @param arguments those that were chosen; there may be fewer than parameters
     */
    default void error(int action, Object[] arguments, EvalError error) {}
  }

  /** A part of a state: a value parameter or a component. */
  public record Part(String name, Domain domain) {}

  private record Condition(Code code, int locals) {}

  private final Automaton given;
  private final Automaton automaton;
  private final Domains domains;
  private final List<Field> parameters;
  private final List<Part> parts = new ArrayList<>();
  private final List<Act> acts = new ArrayList<>();
  private final List<Invariant> asked = new ArrayList<>();
  private final List<Condition> conditions = new ArrayList<>();

  /**
   * @param given what it refines is a part of its states: {@link Automaton#refined}
   * @throws TooLarge if a type has too many values at these sizes
   * @throws EvalError if a number in the source is too long, or a variable has too many values
   */
  public Machine(Automaton given, Sizes sizes) {
    this.given = given;
    automaton = given.refined();
    domains = new Domains(sizes, opaqueTypes(automaton));
    Set<Field> all = new LinkedHashSet<>();
    collect(automaton, all);
    parameters = List.copyOf(all);
    parameters.forEach(field -> parts.add(new Part(field.name(), domains.of(field))));
    automaton
        .state()
        .forEach(component -> parts.add(new Part(component.name(), domains.of(component.type()))));
    Compiler compiler = compiler();
    automaton.actions().forEach(action -> acts.add(new Act(action, compiler)));
    automaton.sides().forEach(side -> acts.add(new Act(side, compiler)));
    Stream.of(automaton.invariants(), automaton.constraints(), automaton.ends(), automaton.starts())
        .forEach(asked::addAll);
    for (Invariant invariant : asked) {
      Compiler.Scope scope = new Compiler.Scope();
      Code code = compiler.code(invariant.condition(), scope);
      conditions.add(new Condition(code, scope.most));
    }
  }

  /** The opaque types of an automaton and of those that it uses, in order. */
  public static List<String> opaqueTypes(Automaton automaton) {
    Set<String> names = new LinkedHashSet<>(automaton.typeParameters());
    automaton.uses().values().forEach(used -> names.addAll(opaqueTypes(used)));
    return List.copyOf(names);
  }

  /**
   * The sizes with each choice of values for the parameters that bounds of ranges have, of those that
   * may meet the assumptions; of none if these are given.
   *
   * @param given the values of some
   */
  public static List<Sizes> sizes(Automaton of, Sizes sizes, Map<String, Integer> given) {
    Automaton refined = of.refined();
    List<String> numbers =
        refined.valueParameters().stream()
            .map(Field::name)
            .filter(refined.numbers()::contains)
            .toList();
    List<Map<String, Integer>> all = new ArrayList<>(List.of(Map.of()));
    for (String name : numbers) {
      Integer one = given.get(name);
      all =
          all.stream()
              .flatMap(values ->
                  IntStream.rangeClosed(one == null ? 0 : one, one == null ? sizes.nat() : one)
                      .mapToObj(n -> with(values, name, n)))
              .toList();
    }
    boolean areGiven = given.keySet().containsAll(numbers);
    Automaton parameters = refined.ofParameters(List.of());
    return all.stream()
        .map(sizes::with)
        .filter(each -> areGiven || areAssumed(parameters, each))
        .toList();
  }

  private static Map<String, Integer> with(Map<String, Integer> values, String name, int value) {
    Map<String, Integer> more = new TreeMap<>(values);
    more.put(name, value);
    return more;
  }

  /** Whether some values of the parameters meet the assumptions, or may do so beyond the bounds. */
  private static boolean areAssumed(Automaton of, Sizes sizes) {
    try {
      Starts starts = new Machine(of, sizes).starts(Map.of());
      return !starts.states().isEmpty() || !starts.bounded().isEmpty();
    } catch (TooLarge | EvalError e) {
      return true; // told where the values are tried
    }
  }

  private static void collect(Automaton automaton, Set<Field> parameters) {
    parameters.addAll(automaton.valueParameters());
    automaton.uses().values().forEach(used -> collect(used, parameters));
  }

  /** Of which this is the meaning. */
  public Automaton automaton() {
    return automaton;
  }

  /** The name of an action by its number. */
  public String name(int action) {
    return acts.get(action).tree.name();
  }

  /** The value parameters, those of used automata included: the first parts of a state. */
  public List<Field> parameters() {
    return parameters;
  }

  /** The opaque types whose elements are not alike: 'choose' takes the first of some. */
  public Set<String> chosen() {
    return Set.copyOf(domains.chosen());
  }

  /** The parts of a state. */
  public List<Part> parts() {
    return List.copyOf(parts);
  }

  Domains domains() {
    return domains;
  }

  /**
   * The start states.
   *
   * @param given the values of those value parameters that are given, by their names
   * @throws TooLarge if there are too many, or values to try for one of their parts
   * @throws EvalError if the condition has no value
   */
  public Starts starts(Map<String, Object> given) {
    return new Starts(this, given);
  }

  /** The names of the elements of the opaque types: {@code bot0} and so on. */
  public List<Field> elements() {
    return domains.elements();
  }

  /**
   * The value of an expression that reads neither state nor parameters.
   *
   * @param constant its variables are {@link #elements}
   * @throws EvalError if it has no value
   * @throws Beyond if it is beyond the bounds
   */
  public Object value(Expr constant) {
    Compiler.Scope scope = new Compiler.Scope();
    scope.push(elements());
    Code code = compiler().code(constant, scope);
    Object[] variables = Arrays.copyOf(domains.elementValues().toArray(), scope.most);
    Object value = code.of(new Frame(new Object[0], new Object[0], 0, variables, 0));
    if (!domains.of(constant.type()).contains(value)) {
      throw new Beyond();
    }
    return value;
  }

  /** The state after an action whose abstract step cannot be taken; the abstract state stays. */
  public Row afterAlone(Row state, int action, List<?> arguments) {
    Act act = new Act(given.actions().get(action), compiler());
    return act.after(frame(state, act.locals(arguments)));
  }

  /** The steps of an abstract automaton that an action takes, or should. */
  public List<String> abstractSteps(
      Refinement refinement, Row before, int action, List<?> arguments) {
    Act act = acts.get(action);
    Frame frame = frame(before, act.locals(arguments));
    return act.texts(refinement.steps().getOrDefault(act.tree.name(), List.of()), frame);
  }

  /**
   * The abstract state that stands in a state, or that the state maps to.
   *
   * @throws EvalError if it maps to none
   * @throws Beyond if that needs a value beyond the bounds
   */
  public String text(Refinement refinement, Row state, boolean isMapped) {
    List<String> texts = new ArrayList<>();
    refinement
        .values()
        .forEach((path, value) -> {
          Compiler.Scope scope = new Compiler.Scope();
          Expr place = refinement.place(path, value.pos());
          Code code = compiler().code(isMapped ? value : place, scope);
          Object found = code.of(frame(state, new Object[scope.most]));
          texts.add(path + " = " + domains.of(place.type()).text(found));
        });
    return String.join(", ", texts);
  }

  private Compiler compiler() {
    return new Compiler(automaton, domains, parameters, false);
  }

  Act act(int action) {
    return acts.get(action);
  }

  Reads reads() {
    return new Reads(automaton, parameters);
  }

  private Frame frame(Row state, Object[] variables) {
    return new Frame(state.items(), state.items(), parameters.size(), variables, 0);
  }

  /** Tells all steps of a state, in the order of the actions and of the values of their parameters. */
  public void steps(Row state, Steps to) {
    for (int i = 0; i < automaton.actions().size(); i++) {
      steps(state, i, to);
    }
  }

  /** The same, of one action, or of a side of a progress: these have the numbers after the actions'. */
  public void steps(Row state, int action, Steps to) {
    steps(
        state,
        action,
        to,
        (choice, arguments) -> {
          Row after = after(state, action, arguments, to);
          if (after != null) {
            to.step(action, arguments, after);
          }
        });
  }

  /** The state after an action, which is enabled; null if there is none: {@code to} is told. */
  @Nullable Row after(Row state, int action, Object[] arguments, Steps to) {
    try {
      return after(state, action, List.of(arguments));
    } catch (Beyond e) {
      to.beyond(action, arguments);
    } catch (EvalError e) {
      to.error(action, arguments, e);
    }
    return null;
  }

  /** Is told for which arguments an action is enabled, and the number of their choice. */
  interface Enabled {

    void take(int choice, Object[] arguments);
  }

  /** Whether the condition of an action has a value for all arguments; else {@code to} is told, too. */
  boolean steps(Row state, int action, Steps to, Enabled enabled) {
    Act act = acts.get(action);
    return steps(action, act, 0, 0, 0, frame(state, act.locals()), to, enabled);
  }

  private static boolean steps(
      int number, Act act, int level, int first, int of, Frame frame, Steps to, Enabled enabled) {
    int conjunct = first;
    try {
      while (conjunct < act.levels.length && act.levels[conjunct] == level) {
        if (!act.test(conjunct, frame)) {
          to.conjunctIsFalse(number, conjunct);
          return true;
        }
        conjunct++;
      }
    } catch (Beyond e) {
      to.beyond(number, Arrays.copyOf(frame.locals, level));
      return false;
    } catch (EvalError e) {
      to.error(number, Arrays.copyOf(frame.locals, level), e);
      return false;
    }
    if (level == act.parameters.size()) {
      enabled.take(of, Arrays.copyOf(frame.locals, level));
      return true;
    }
    boolean isDecided = true;
    List<Object> values = act.parameters.get(level).instances();
    for (int i = 0; i < values.size(); i++) {
      frame.locals[level] = values.get(i);
      int choice = of * values.size() + i;
      isDecided &= steps(number, act, level + 1, conjunct, choice, frame, to, enabled);
    }
    return isDecided;
  }

  /** Whether none of the arguments stands for values beyond the bounds. */
  public boolean areWithin(int action, Object[] arguments) {
    List<Domain> domains = acts.get(action).parameters;
    for (int i = 0; i < arguments.length; i++) {
      if (!domains.get(i).contains(arguments[i])) {
        return false;
      }
    }
    return true;
  }

  /** The parameters of an action of which some values are not tried, nor any that stands for them. */
  public List<String> untried(int action) {
    Act act = acts.get(action);
    return act.tree.parameters().stream()
        .filter(field -> domains.of(field.type()).hasMore())
        .map(Field::name)
        .toList();
  }

  /** An action with its arguments, as in {@code release(bot0, {A})}. */
  public String text(int action, Object[] arguments) {
    return acts.get(action).text(arguments);
  }

  /** What is fair with a step: of {@code allocate(c, S)} that is fair for c, {@code allocate(bot0)}. */
  public String text(Fairness fairness, int action, Object[] arguments) {
    List<String> texts = new ArrayList<>();
    for (int i : fairness.each()) {
      texts.add(acts.get(action).parameters.get(i).text(arguments[i]));
    }
    return fairness.group() + "(" + String.join(", ", texts) + ")";
  }

  /**
   * The first conjunct of an action's condition that is false; empty if the action is enabled.
   *
   * @throws EvalError if the condition has no value
   * @throws Beyond if it needs a value beyond the bounds
   */
  public Optional<Conjunct> firstFalse(Row state, int action, List<?> arguments) {
    Act act = acts.get(action);
    int number = act.firstFalse(frame(state, act.locals(arguments)));
    return number < 0 ? Optional.empty() : Optional.of(act.tree.pre().get(number));
  }

  /**
   * The state after an action, which is enabled.
   *
   * @throws EvalError if it has no value
   * @throws Beyond if it is beyond the bounds
   */
  public Row after(Row state, int action, List<?> arguments) {
    Act act = acts.get(action);
    return act.after(frame(state, act.locals(arguments)));
  }

  /**
   * Whether an invariant is true.
   *
   * @throws EvalError if it has no value
   * @throws Beyond if it needs a value beyond the bounds
   */
  public boolean holds(Invariant invariant, Row state) {
    Condition condition = conditions.get(asked.indexOf(invariant));
    return condition.code.test(frame(state, new Object[condition.locals]));
  }

  /** The part of an invariant that is false, where it is. */
  public Witness witness(Invariant invariant, Row state) {
    return new Witness.Finder(compiler(), state, parameters.size()).find(invariant.condition());
  }
}
