package org.starl.lang.tree;

/** A place in a source: line and column, both from 1. */
public record Pos(int line, int column) {

  @Override
  public String toString() {
    return line + ":" + column;
  }
}
