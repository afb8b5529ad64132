package org.starl.trace;

import org.jspecify.annotations.Nullable;

/**
 * The part of a robot that an event is of: the app, or an instance of a primitive. Its name is {@code
 * app}, {@code mutex/crossing}, or, for a second channel of a primitive, {@code
 * election.synod/crossing}. Equal names are equal instances.
 */
public final class Instance implements Comparable<Instance> {

  /** The app of a robot. */
  public static final Instance APP = of("app");

  private final String name;
  private final String kind;
  private final String primitive;
  private final String xid;

  private Instance(String name, String kind, String xid) {
    this.name = name;
    this.kind = kind;
    this.xid = xid;
    int dot = kind.indexOf('.');
    this.primitive = dot < 0 ? kind : kind.substring(0, dot);
  }

  /** What a robot has once, such as {@code app} or {@code motion}. */
  public static Instance of(String primitive) {
    return new Instance(primitive, primitive, "");
  }

  /**
   * An instance of a primitive.
   *
   * @param kind the primitive, and after a dot its channel if it has several
   */
  public static Instance of(String kind, String xid) {
    return new Instance(kind + "/" + xid, kind, xid);
  }

  /** The instance of this name: for readers of traces. */
  public static Instance named(String name) {
    int slash = name.indexOf('/');
    return slash < 0
        ? of(name)
        : new Instance(name, name.substring(0, slash), name.substring(slash + 1));
  }

  /** The name, as {@code election.synod/crossing}. */
  public String name() {
    return name;
  }

  /** The primitive and its channel: {@code election.synod}. */
  public String kind() {
    return kind;
  }

  /** The primitive: {@code election}. */
  public String primitive() {
    return primitive;
  }

  /** The instance that has this channel: itself, unless it has several. */
  public Instance owner() {
    return primitive.equals(kind) || xid.isEmpty() ? this : of(primitive, xid);
  }

  /** The id of the instance: {@code crossing}; empty if a robot has the primitive once. */
  public String xid() {
    return xid;
  }

  @Override
  public int compareTo(Instance other) {
    return name.compareTo(other.name);
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return this == other || (other instanceof Instance that && name.equals(that.name));
  }

  @Override
  public int hashCode() {
    return name.hashCode();
  }

  @Override
  public String toString() {
    return name;
  }
}
