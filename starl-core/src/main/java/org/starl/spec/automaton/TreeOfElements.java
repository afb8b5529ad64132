package org.starl.spec.automaton;

import java.util.AbstractSet;
import java.util.Collections;
import java.util.Comparator;
import java.util.Iterator;
import java.util.SortedSet;
import org.jspecify.annotations.Nullable;

/** A set in the order of {@link Sets#compare}, never changed. One more or one less takes logarithmic time. */
@SuppressWarnings("JdkObsolete") // no more than what theories name
final class TreeOfElements<T> extends AbstractSet<T> implements SortedSet<T> {

  private final @Nullable Tree<T, Object> root;

  /** The keys of a map. */
  @SuppressWarnings("unchecked") // its values are not looked at
  TreeOfElements(@Nullable Tree<T, ?> map) {
    root = (Tree<T, Object>) map;
  }

  TreeOfElements<T> with(T element) {
    return of(Tree.put(root, element, true));
  }

  TreeOfElements<T> without(T element) {
    return of(Tree.remove(root, element));
  }

  private TreeOfElements<T> of(@Nullable Tree<T, Object> changed) {
    return changed == root ? this : new TreeOfElements<>(changed);
  }

  @Override
  public int size() {
    return Tree.size(root);
  }

  @Override
  @SuppressWarnings("unchecked") // as in a TreeSet, looking for anything else is a bug
  public boolean contains(Object element) {
    return Tree.get(root, (T) element) != null;
  }

  @Override
  public Iterator<T> iterator() {
    return Tree.keys(root);
  }

  @Override
  public Comparator<Object> comparator() {
    return Sets.ORDER;
  }

  @Override
  public T first() {
    return iterator().next();
  }

  @Override
  public T last() {
    return Tree.last(root);
  }

  @Override
  public SortedSet<T> subSet(T from, T to) {
    return Collections.unmodifiableSortedSet(Sets.copy(this).subSet(from, to));
  }

  @Override
  public SortedSet<T> headSet(T to) {
    return Collections.unmodifiableSortedSet(Sets.copy(this).headSet(to));
  }

  @Override
  public SortedSet<T> tailSet(T from) {
    return Collections.unmodifiableSortedSet(Sets.copy(this).tailSet(from));
  }
}
