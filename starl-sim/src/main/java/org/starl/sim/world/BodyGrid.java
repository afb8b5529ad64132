package org.starl.sim.world;

import org.jspecify.annotations.Nullable;

/**
 * Finds the bodies near a point: an unbounded grid of square cells, hashed into buckets; each
 * bucket has a linked list of bodies. Adding, moving and removing cost constant time.
 */
final class BodyGrid {

  /** Receives each body of a query. */
  interface Visitor {
    void visit(Body body);
  }

  private static final int LEAST_BUCKETS = 64;

  /** A search of more cells than this visits all bodies instead. */
  private static final double MOST_CELLS_A_BUCKET = 4;

  private final double cellMm;
  private @Nullable Body[] buckets = new Body[LEAST_BUCKETS];
  private int size;

  BodyGrid(double cellMm) {
    this.cellMm = cellMm;
  }

  void put(Body body) {
    if (size >= buckets.length) {
      grow();
    }
    body.cellX = cell(body.xMm());
    body.cellY = cell(body.yMm());
    link(body);
    size++;
  }

  void take(Body body) {
    unlink(body);
    size--;
  }

  /** Must be called after a body has moved. */
  void update(Body body) {
    int cellX = cell(body.xMm());
    int cellY = cell(body.yMm());
    if (cellX != body.cellX || cellY != body.cellY) {
      unlink(body);
      body.cellX = cellX;
      body.cellY = cellY;
      link(body);
    }
  }

  /**
   * Visits a superset of the bodies whose centre, at its last update, was within {@code rangeMm} of
   * a point.
   */
  void forEachNear(double xMm, double yMm, double rangeMm, Visitor visitor) {
    int lastX = cell(xMm + rangeMm);
    int lastY = cell(yMm + rangeMm);
    double cellsASide = 2 * rangeMm / cellMm + 1;
    if (cellsASide * cellsASide > MOST_CELLS_A_BUCKET * buckets.length) {
      forEach(visitor);
      return;
    }
    for (int cellX = cell(xMm - rangeMm); cellX <= lastX; cellX++) {
      for (int cellY = cell(yMm - rangeMm); cellY <= lastY; cellY++) {
        Body body = buckets[bucket(cellX, cellY)];
        while (body != null) {
          // A visitor must not move bodies, so the list does not change.
          if (body.cellX == cellX && body.cellY == cellY) {
            visitor.visit(body);
          }
          body = body.nextInBucket;
        }
      }
    }
  }

  private void forEach(Visitor visitor) {
    for (Body first : buckets) {
      for (Body body = first; body != null; body = body.nextInBucket) {
        visitor.visit(body);
      }
    }
  }

  private int cell(double mm) {
    return (int) Math.floor(mm / cellMm);
  }

  private int bucket(int cellX, int cellY) {
    int mixed = cellX * 0x9E3779B1 + cellY * 0x85EBCA77;
    return (mixed ^ (mixed >>> 15)) & (buckets.length - 1);
  }

  private void link(Body body) {
    int bucket = bucket(body.cellX, body.cellY);
    Body first = buckets[bucket];
    body.nextInBucket = first;
    body.previousInBucket = null;
    if (first != null) {
      first.previousInBucket = body;
    }
    buckets[bucket] = body;
  }

  private void unlink(Body body) {
    Body next = body.nextInBucket;
    Body previous = body.previousInBucket;
    if (previous == null) {
      buckets[bucket(body.cellX, body.cellY)] = next;
    } else {
      previous.nextInBucket = next;
    }
    if (next != null) {
      next.previousInBucket = previous;
    }
    body.nextInBucket = null;
    body.previousInBucket = null;
  }

  private void grow() {
    @Nullable Body[] old = buckets;
    buckets = new Body[old.length * 2];
    for (Body first : old) {
      Body body = first;
      while (body != null) {
        Body next = body.nextInBucket;
        link(body);
        body = next;
      }
    }
  }
}
