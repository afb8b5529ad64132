package org.starl.lang.tree;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.starl.lang.tree.Automaton.Declared;
import org.starl.lang.tree.Automaton.JavaType;
import org.starl.lang.tree.Type.Field;

/**
 * A program of a source, checked: what one process does. In its expressions a variable of the program
 * is an {@link Expr.Component}; {@code mux.crit} is an {@link Expr.Get} of the {@link Expr.Component}
 * of an instance, whose type is {@link Primitive#type}; a given value and a Java function are an
 * {@link Expr.Parameter}, the function's of a {@link Type.MapOf} if it has parameters; the process's
 * own id is the {@link Expr.Variable} {@link #SELF}. The {@link Automaton} of all processes that run it
 * has the same name, and the invariants.
 *
 * @param typeParameters the opaque types, {@link #IDS} the first
 * @param types the types that it declares, in order, with their comments
 * @param given what a process is given at its start
 * @param javaFunctions pure and total functions in Java
 * @param functions functions of the program; none reads its state
 * @param everyMs the time between two looks at the guards of a location, above 0
 * @param locations at least one; the first one is where it begins
 * @param javaClass the full name of its class in Java; empty if the source names none
 * @param javaTypes the Java types that stand for types of the source
 * @param comment the lines of comment before it
 */
public record Program(
    String name,
    List<String> typeParameters,
    List<Declared> types,
    List<Field> given,
    List<JavaFunction> javaFunctions,
    List<Function> functions,
    List<Instance> instances,
    List<Variable> variables,
    int everyMs,
    List<Location> locations,
    String javaClass,
    Map<Type, JavaType> javaTypes,
    List<String> comment,
    Pos pos) {

  /** The variable that is the id of the process itself, of the type {@link #IDS}. */
  public static final String SELF = "self";

  /** The type of the processes' ids. */
  public static final String IDS = "PIDS";

  /** The type of texts, which programs hand to primitives alone. */
  public static final String TEXT = "Text";

  /**
   * {@code java fun way(trip: Trip): list[Zones] = "a.package.Class.method"}.
   *
   * @param method the class's full name, a dot, and the name of the static method
   */
  public record JavaFunction(
      String name, List<Field> parameters, Type result, String method, Pos pos) {}

  /**
   * {@code uses mux: Mutex(xid, reg)}.
   *
   * @param arguments of given values, and of instances before this one
   */
  public record Instance(
      String name, Primitive primitive, List<Expr> arguments, List<String> comment, Pos pos) {}

  /**
   * A variable.
   *
   * @param start of given values and functions alone
   * @param comment the lines of comment before it
   * @param note the comment at the end of its line; empty if there is none
   */
  public record Variable(
      String name, Type type, Expr start, List<String> comment, String note, Pos pos) {}

  /** A location; the program ends at one without branches. */
  public record Location(String name, List<Branch> branches, List<String> comment, Pos pos) {}

  /**
   * A branch: taken if its guard holds and none before it in its location does.
   *
   * @param guard {@code true} if the source has none; an outcome of a primitive is one of its
   *     conjuncts, and at most one is
   * @param text the guard as in the source, on one line; empty if there is none
   * @param statements done in order, as one atomic action; at most one call of each instance
   * @param to the location after it; empty if the program begins anew: its variables have their start
   *     values, it is at its first location, and registers under a new id
   * @param toPos where the source says so
   */
  public record Branch(
      Expr guard, String text, List<Statement> statements, String to, Pos toPos, Pos pos) {

    /** Whether the program begins anew after it. */
    public boolean isRestart() {
      return to.isEmpty();
    }
  }

  /** A statement of a branch. */
  public sealed interface Statement {

    /**
     * {@code plist := reg.rList}.
     *
     * @param text as in the source, on one line
     */
    record Assign(String variable, Expr value, String text, Pos pos) implements Statement {}

    /**
     * {@code mux.release({z})}.
     *
     * @param text as in the source, on one line
     */
    record Call(String instance, Primitive.Call call, List<Expr> arguments, String text, Pos pos)
        implements Statement {}
  }

  /** The instance of this name. */
  public Optional<Instance> instance(String wanted) {
    return instances.stream().filter(each -> each.name().equals(wanted)).findFirst();
  }
}
