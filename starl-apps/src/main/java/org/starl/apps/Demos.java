package org.starl.apps;

import java.util.List;
import java.util.Optional;
import org.starl.apps.hello.HelloDemo;
import org.starl.apps.intersection.IntersectionDemo;

/** The apps that there are. */
public final class Demos {

  private static final List<Demo> ALL = List.of(new HelloDemo(), new IntersectionDemo());

  private Demos() {}

  /** All of them, in the order of their names. */
  public static List<Demo> all() {
    return ALL;
  }

  /** Their names, in order. */
  public static List<String> names() {
    return ALL.stream().map(Demo::name).toList();
  }

  public static Optional<Demo> byName(String name) {
    return ALL.stream().filter(demo -> demo.name().equals(name)).findFirst();
  }
}
