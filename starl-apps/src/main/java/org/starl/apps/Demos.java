package org.starl.apps;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import org.starl.input.BadInput;
import org.starl.input.FailureText;

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
   * The apps that files {@code META-INF/services/org.starl.apps.Demo} on the class path name.
   *
   * @throws BadInput if an app cannot be created, or has the name of one of {@code known}
   */
  public static Demos installed(Demos known) {
    List<Demo> found = new ArrayList<>();
    try {
      for (Demo demo : ServiceLoader.load(Demo.class)) {
        if (known.plus(found).byName(demo.name()).isPresent()) {
          String problem = ": its name " + BadInput.quote(demo.name()) + " is taken";
          throw new BadInput(demo.getClass().getName() + problem + "; expected another");
        }
        found.add(demo);
      }
    } catch (ServiceConfigurationError error) {
      throw FailureText.service(Demo.class, error);
    }
    return new Demos(found);
  }

  /** These apps, then {@code others}. */
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
