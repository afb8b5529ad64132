package org.starl.spec.automaton;

import java.util.Iterator;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.BiPredicate;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/**
 * A total function in a state of a theory, {@code [PIDS -> Zoneset]}: a default value, or a function
 * of the argument, and finitely many exceptions. Immutable. A change takes time and memory for the
 * logarithm of the exceptions.
 *
 * @param <K> arguments, in their natural order
 * @param <V> compared by {@code equals}
 */
public final class Fun<K extends Comparable<? super K>, V> {

  // A constant, or a function that is equal to itself alone.
  private final Default<K, V> otherwise;
  // No value equals the default.
  private final @Nullable Tree<K, V> exceptions;

  private interface Default<K, V> {
    V at(K argument);
  }

  private record Constant<K, V>(V value) implements Default<K, V> {
    @Override
    public V at(K argument) {
      return value;
    }
  }

  private Fun(Default<K, V> otherwise, @Nullable Tree<K, V> exceptions) {
    this.otherwise = otherwise;
    this.exceptions = exceptions;
  }

  /** {@code LAMBDA x: value}. */
  public static <K extends Comparable<? super K>, V> Fun<K, V> always(V value) {
    return new Fun<K, V>(new Constant<>(value), null);
  }

  /** {@code LAMBDA x: f(x)}; it has no {@link #defaultValue}. */
  public static <K extends Comparable<? super K>, V> Fun<K, V> of(
      Function<? super K, ? extends V> f) {
    return new Fun<K, V>(f::apply, null);
  }

  /** Its value at {@code argument}. */
  public V at(K argument) {
    V exception = Tree.get(exceptions, argument);
    return exception == null ? otherwise.at(argument) : exception;
  }

  /** {@code f WITH [(argument) := value]}; this object if that changes nothing. */
  public Fun<K, V> with(K argument, V value) {
    if (value.equals(at(argument))) {
      return this;
    }
    return new Fun<>(
        otherwise,
        value.equals(otherwise.at(argument))
            ? Tree.remove(exceptions, argument)
            : Tree.put(exceptions, argument, value));
  }

  /** The value at all arguments that are no exceptions. */
  public V defaultValue() {
    if (otherwise instanceof Constant<K, V> constant) {
      return constant.value;
    }
    throw new IllegalStateException("each argument has a value of its own");
  }

  /** The exceptions' arguments, in order. */
  public Set<K> arguments() {
    return new TreeOfElements<>(exceptions);
  }

  /** The number of exceptions. */
  public int size() {
    return Tree.size(exceptions);
  }

  /** Whether it has no exception. */
  public boolean isConstant() {
    return exceptions == null;
  }

  /** Visits every exception, in order: argument and value. */
  public void forEach(BiConsumer<? super K, ? super V> visitor) {
    Tree.nodes(exceptions).forEachRemaining(node -> visitor.accept(node.key, node.value));
  }

  /** Whether {@code test} is true of every exception: argument and value. */
  public boolean allMatch(BiPredicate<? super K, ? super V> test) {
    Iterator<Tree<K, V>> nodes = Tree.nodes(exceptions);
    while (nodes.hasNext()) {
      Tree<K, V> node = nodes.next();
      if (!test.test(node.key, node.value)) {
        return false;
      }
    }
    return true;
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return this == other
        || (other instanceof Fun<?, ?> that
            && otherwise.equals(that.otherwise)
            && hasEqual(exceptions, that.exceptions));
  }

  private static boolean hasEqual(@Nullable Tree<?, ?> one, @Nullable Tree<?, ?> other) {
    if (one == other || Tree.size(one) != Tree.size(other)) {
      return one == other;
    }
    Iterator<? extends Tree<?, ?>> nodes = Tree.nodes(one);
    Iterator<? extends Tree<?, ?>> others = Tree.nodes(other);
    while (nodes.hasNext()) {
      Tree<?, ?> node = nodes.next();
      Tree<?, ?> with = others.next();
      if (!node.key.equals(with.key) || !node.value.equals(with.value)) {
        return false;
      }
    }
    return true;
  }

  /** That of a map with the exceptions. */
  @Override
  public int hashCode() {
    int hash = 0;
    Iterator<Tree<K, V>> nodes = Tree.nodes(exceptions);
    while (nodes.hasNext()) {
      Tree<K, V> node = nodes.next();
      hash += node.key.hashCode() ^ node.value.hashCode();
    }
    return hash;
  }

  /** {@code (bot0: [A, C], bot1: [B])}: the exceptions. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder("(");
    forEach((argument, value) ->
        text.append(text.length() > 1 ? ", " : "").append(argument).append(": ").append(value));
    return text.append(')').toString();
  }
}
