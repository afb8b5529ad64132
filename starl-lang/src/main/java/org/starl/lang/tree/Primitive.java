package org.starl.lang.tree;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.starl.lang.tree.Action.Fairness;
import org.starl.lang.tree.Automaton.Progress;
import org.starl.lang.tree.Type.Field;

/**
 * A primitive as programs use it, and the automaton behind it. Its expressions are those of the
 * automaton's own source: components are the automaton's; the variable {@link Program#SELF} is the
 * process.
 *
 * @param parameters what an instance is made of; a parameter's type may be that of another primitive
 * @param steps the actions that it takes by itself
 * @param assumed what is assumed to happen in each run, besides that steps are fair
 * @param start what holds of an instance's first state, besides the automaton's own start
 * @param rest what holds of a process that may end its attempt: it holds nothing, and waits for nothing
 * @param javaType the full name of its Java class or interface
 * @param javaMade a Java expression that makes an instance: of {@code gvh} and the parameters
 * @param comment the lines of comment before it
 */
public record Primitive(
    String name,
    List<Field> parameters,
    Automaton automaton,
    List<Call> calls,
    List<Value> values,
    List<Outcome> outcomes,
    List<Step> steps,
    List<Progress> assumed,
    Expr start,
    Expr rest,
    String javaType,
    String javaMade,
    List<String> comment,
    Pos pos) {

  /**
   * A call, which is a step of the automaton.
   *
   * @param pre what is asked of the caller, besides the step's own condition
   * @param arguments of the step; its variables are the parameters, and {@link Program#SELF}
   * @param java a Java expression after the instance and a dot, of the parameters' names
   */
  public record Call(
      String name,
      List<Field> parameters,
      List<Expr> pre,
      Action action,
      List<Expr> arguments,
      String java) {}

  /**
   * A value that programs read.
   *
   * @param java a Java expression after the instance and a dot
   */
  public record Value(String name, Type type, Expr value, String java) {}

  /**
   * A truth value that programs read, and that becomes true by a step which the primitive takes or
   * does not take: such as the failure of a request.
   *
   * @param java a Java expression after the instance and a dot
   */
  public record Outcome(String name, Action action, List<Expr> arguments, String java) {}

  /**
   * A step that it takes by itself.
   *
   * @param fairness empty if it need not be taken; that of its action is of the automaton's own runs
   */
  public record Step(Action action, Optional<Fairness> fairness) {}

  /** The type of its instances in programs: a record of what can be read. */
  public Type.Rec type() {
    List<Field> fields = new ArrayList<>();
    values.forEach(value -> fields.add(new Field(value.name(), value.type())));
    outcomes.forEach(outcome -> fields.add(new Field(outcome.name(), Type.Bool.BOOL)));
    return new Type.Rec("", name, List.copyOf(fields));
  }

  /** The call of this name. */
  public Optional<Call> call(String wanted) {
    return calls.stream().filter(each -> each.name().equals(wanted)).findFirst();
  }

  /** The value of this name. */
  public Optional<Value> value(String wanted) {
    return values.stream().filter(each -> each.name().equals(wanted)).findFirst();
  }

  /** The outcome of this name. */
  public Optional<Outcome> outcome(String wanted) {
    return outcomes.stream().filter(each -> each.name().equals(wanted)).findFirst();
  }
}
