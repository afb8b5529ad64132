package org.starl.spec.automaton;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.NoSuchElementException;
import org.jspecify.annotations.Nullable;

/**
 * A sorted map that is never changed, as a weight-balanced tree; null is the empty map. A change
 * makes a map that shares all with the old one except the path to the change, so it takes logarithmic
 * time and memory. Its keys are in the order of {@link Sets#compare}.
 */
final class Tree<K, V> {

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

  /** The map of these keys, which are in order, to one value. */
  static <K, V> @Nullable Tree<K, V> of(List<? extends K> keys, V value) {
    if (keys.isEmpty()) {
      return null;
    }
    int middle = keys.size() / 2;
    return new Tree<K, V>(
        of(keys.subList(0, middle), value),
        keys.get(middle),
        value,
        of(keys.subList(middle + 1, keys.size()), value));
  }

  static int size(@Nullable Tree<?, ?> tree) {
    return tree == null ? 0 : tree.size;
  }

  /** The value at {@code key}; null if there is none. */
  static <K, V> @Nullable V get(@Nullable Tree<K, V> tree, K key) {
    Tree<K, V> at = tree;
    while (at != null) {
      int order = Sets.compare(key, at.key);
      if (order == 0) {
        return at.value;
      }
      at = order < 0 ? at.left : at.right;
    }
    return null;
  }

  /** {@code tree} with {@code value} at {@code key}. */
  static <K, V> Tree<K, V> put(@Nullable Tree<K, V> tree, K key, V value) {
    if (tree == null) {
      return new Tree<>(null, key, value, null);
    }
    int order = Sets.compare(key, tree.key);
    if (order == 0) {
      return value == tree.value ? tree : new Tree<>(tree.left, tree.key, value, tree.right);
    }
    return order < 0
        ? balanced(put(tree.left, key, value), tree, tree.right)
        : balanced(tree.left, tree, put(tree.right, key, value));
  }

  /** {@code tree} without {@code key}. */
  static <K, V> @Nullable Tree<K, V> remove(@Nullable Tree<K, V> tree, K key) {
    if (tree == null) {
      return null;
    }
    int order = Sets.compare(key, tree.key);
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

  private static <K, V> Tree<K, V> first(Tree<K, V> tree) {
    Tree<K, V> at = tree;
    while (at.left != null) {
      at = at.left;
    }
    return at;
  }

  private static <K, V> @Nullable Tree<K, V> withoutFirst(Tree<K, V> tree) {
    return tree.left == null ? tree.right : balanced(withoutFirst(tree.left), tree, tree.right);
  }

  /** With the key and value of {@code root}, of two sides one of which may have changed by one. */
  private static <K, V> Tree<K, V> balanced(
      @Nullable Tree<K, V> left, Tree<K, V> root, @Nullable Tree<K, V> right) {
    if (left == root.left && right == root.right) {
      return root;
    }
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

  private static <K, V> Tree<K, V> node(
      @Nullable Tree<K, V> left, Tree<K, V> of, @Nullable Tree<K, V> right) {
    return new Tree<>(left, of.key, of.value, right);
  }

  static <K> K last(@Nullable Tree<K, ?> tree) {
    Tree<K, ?> at = tree;
    while (at != null && at.right != null) {
      at = at.right;
    }
    if (at == null) {
      throw new NoSuchElementException();
    }
    return at.key;
  }

  static <K> Iterator<K> keys(@Nullable Tree<K, ?> tree) {
    Iterator<? extends Tree<K, ?>> nodes = nodes(tree);
    return new Iterator<>() {
      @Override
      public boolean hasNext() {
        return nodes.hasNext();
      }

      @Override
      public K next() {
        return nodes.next().key;
      }
    };
  }

  /** Its nodes, in the order of their keys. */
  static <K, V> Iterator<Tree<K, V>> nodes(@Nullable Tree<K, V> tree) {
    return new InOrder<>(tree);
  }

  private static final class InOrder<K, V> implements Iterator<Tree<K, V>> {

    private static final int DEEP = 16;

    // The next one last, and after each one those to the right of it.
    private final Deque<Tree<K, V>> ahead;

    InOrder(@Nullable Tree<K, V> tree) {
      ahead = new ArrayDeque<>(Math.min(size(tree), DEEP));
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
