package org.starl.lang.read;

import org.starl.lang.tree.Pos;

/**
 * A name in a source, and what it means: for editors.
 *
 * @param at where the name stands
 * @param name as written
 * @param meaning {@code crit_set: [PIDS -> Zoneset]}
 * @param declaredIn the file of its declaration
 * @param declaredAt where its declaration begins
 */
public record Reference(Pos at, String name, String meaning, String declaredIn, Pos declaredAt) {

  /** Whether the name stands at {@code pos}. */
  public boolean covers(Pos pos) {
    return pos.line() == at.line()
        && pos.column() >= at.column()
        && pos.column() < at.column() + name.length();
  }
}
