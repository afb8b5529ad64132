package org.starl.apps;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.starl.apps.hello.HelloDemo;
import org.starl.apps.intersection.IntersectionDemo;
import org.starl.apps.race.RaceDemo;

/**
 * Apps that a command line can run.
 *
 * @param all in the order of their names
 */
public record Demos(List<Demo> all) {

  /** Those that StarL brings. */
  public static final Demos STANDARD =
      new Demos(List.of(new HelloDemo(), new IntersectionDemo(), new RaceDemo()));

  public Demos {
    all = List.copyOf(all);
  }

  /** These, then {@code others}. */
  public Demos plus(List<Demo> others) {
    List<Demo> both = new ArrayList<>(all);
    both.addAll(others);
    return new Demos(both);
  }

  /** Their names, in order. */
  public List<String> names() {
    return all.stream().map(Demo::name).toList();
  }

  public Optional<Demo> byName(String name) {
    return all.stream().filter(demo -> demo.name().equals(name)).findFirst();
  }
}
