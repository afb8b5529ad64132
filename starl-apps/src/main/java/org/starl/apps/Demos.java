package org.starl.apps;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import org.starl.input.BadInput;

/**
 * Apps that a command line can run.
 *
 * @param all in the order of their names
 */
public record Demos(List<Demo> all) {

  public Demos {
    all = List.copyOf(all);
  }

  /**
   * Those that the class path holds besides: {@code META-INF/services/org.starl.apps.Demo} names
   * them.
   *
   * @throws BadInput if one cannot be made, or is called as one of {@code known} is
   */
  public static Demos installed(Demos known) {
    List<Demo> found = new ArrayList<>();
    try {
      for (Demo demo : ServiceLoader.load(Demo.class)) {
        if (known.plus(found).byName(demo.name()).isPresent()) {
          String where = demo.getClass().getName();
          throw new BadInput(
              where + ": its name " + BadInput.quote(demo.name()) + " is taken; expected another");
        }
        found.add(demo);
      }
    } catch (ServiceConfigurationError error) {
      throw new BadInput("META-INF/services: " + error.getMessage());
    }
    return new Demos(found);
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
