package org.starl.spec.automaton;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.NoSuchElementException;
import org.jspecify.annotations.Nullable;

/**
 * A sorted map that is never changed, as a weight-balanced tree; null is the empty map. A change
 * makes a map that shares all with the old one except the path to the change, so it takes logarithmic
 * time and memory.
 *
 * @param <K> arguments, in their natural order
 */
final class Tree<K extends Comparable<? super K>, V> {

  // A tree is balanced if no side weighs more than three times the other. If an inner grandchild
  // weighs twice its sibling, or more, it becomes the root. These are the only whole numbers with
  // which a tree stays balanced: Hirai, Yamamoto, "Balancing weight-balanced trees", 2011.
  private static final int MOST = 3;
  private static final int INNER = 2;

  final K key;
  final V value;
  final @Nullable Tree<K, V> left;
  final @Nullable Tree<K, V> right;
  private final int size;

  private Tree(@Nullable Tree<K, V> left, K key, V value, @Nullable Tree<K, V> right) {
    this.left = left;
    this.key = key;
    this.value = value;
    this.right = right;
    size = size(left) + 1 + size(right);
  }

  static int size(@Nullable Tree<?, ?> tree) {
    return tree == null ? 0 : tree.size;
  }

  /** The value at {@code key}; null if there is none. */
  static <K extends Comparable<? super K>, V> @Nullable V get(@Nullable Tree<K, V> tree, K key) {
    Tree<K, V> at = tree;
    while (at != null) {
      int order = key.compareTo(at.key);
      if (order == 0) {
        return at.value;
      }
      at = order < 0 ? at.left : at.right;
    }
    return null;
  }

  /** {@code tree} with {@code value} at {@code key}. */
  static <K extends Comparable<? super K>, V> Tree<K, V> put(
      @Nullable Tree<K, V> tree, K key, V value) {
    if (tree == null) {
      return new Tree<>(null, key, value, null);
    }
    int order = key.compareTo(tree.key);
    if (order == 0) {
      return new Tree<>(tree.left, tree.key, value, tree.right);
    }
    return order < 0
        ? balanced(put(tree.left, key, value), tree, tree.right)
        : balanced(tree.left, tree, put(tree.right, key, value));
  }

  /** {@code tree} without {@code key}. */
  static <K extends Comparable<? super K>, V> @Nullable Tree<K, V> remove(
      @Nullable Tree<K, V> tree, K key) {
    if (tree == null) {
      return null;
    }
    int order = key.compareTo(tree.key);
    if (order < 0) {
      return balanced(remove(tree.left, key), tree, tree.right);
    }
    if (order > 0) {
      return balanced(tree.left, tree, remove(tree.right, key));
    }
    if (tree.left == null || tree.right == null) {
      return tree.left == null ? tree.right : tree.left;
    }
    return balanced(tree.left, first(tree.right), withoutFirst(tree.right));
  }

  private static <K extends Comparable<? super K>, V> Tree<K, V> first(Tree<K, V> tree) {
    Tree<K, V> at = tree;
    while (at.left != null) {
      at = at.left;
    }
    return at;
  }

  private static <K extends Comparable<? super K>, V> @Nullable Tree<K, V> withoutFirst(
      Tree<K, V> tree) {
    return tree.left == null ? tree.right : balanced(withoutFirst(tree.left), tree, tree.right);
  }

  /** With the key and value of {@code root}, of two sides one of which may have changed by one. */
  private static <K extends Comparable<? super K>, V> Tree<K, V> balanced(
      @Nullable Tree<K, V> left, Tree<K, V> root, @Nullable Tree<K, V> right) {
    if (right != null && weight(right) > MOST * weight(left)) {
      Tree<K, V> inner = right.left;
      return inner == null || weight(inner) < INNER * weight(right.right)
          ? node(node(left, root, inner), right, right.right)
          : node(node(left, root, inner.left), inner, node(inner.right, right, right.right));
    }
    if (left != null && weight(left) > MOST * weight(right)) {
      Tree<K, V> inner = left.right;
      return inner == null || weight(inner) < INNER * weight(left.left)
          ? node(left.left, left, node(inner, root, right))
          : node(node(left.left, left, inner.left), inner, node(inner.right, root, right));
    }
    return node(left, root, right);
  }

  private static int weight(@Nullable Tree<?, ?> tree) {
    return size(tree) + 1;
  }

  private static <K extends Comparable<? super K>, V> Tree<K, V> node(
      @Nullable Tree<K, V> left, Tree<K, V> of, @Nullable Tree<K, V> right) {
    return new Tree<>(left, of.key, of.value, right);
  }

  /** Its nodes, in the order of their keys. */
  static <K extends Comparable<? super K>, V> Iterator<Tree<K, V>> nodes(
      @Nullable Tree<K, V> tree) {
    return new InOrder<>(tree);
  }

  private static final class InOrder<K extends Comparable<? super K>, V>
      implements Iterator<Tree<K, V>> {

    // The next one last, and after each one those to the right of it.
    private final Deque<Tree<K, V>> ahead = new ArrayDeque<>();

    InOrder(@Nullable Tree<K, V> tree) {
      descend(tree);
    }

    private void descend(@Nullable Tree<K, V> tree) {
      for (Tree<K, V> at = tree; at != null; at = at.left) {
        ahead.push(at);
      }
    }

    @Override
    public boolean hasNext() {
      return !ahead.isEmpty();
    }

    @Override
    public Tree<K, V> next() {
      if (ahead.isEmpty()) {
        throw new NoSuchElementException();
      }
      Tree<K, V> next = ahead.pop();
      descend(next.right);
      return next;
    }
  }
}
