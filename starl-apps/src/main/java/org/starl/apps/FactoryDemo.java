package org.starl.apps;

import java.util.List;
import org.starl.trace.Vocabulary;

/** A demo of an app that also runs on robots: its factory says what the two have in common. */
public interface FactoryDemo extends Demo {

  /** The app's factory. */
  AppFactory factory();

  @Override
  default String name() {
    return factory().name();
  }

  @Override
  default List<Parameter> parameters() {
    return factory().parameters();
  }

  @Override
  default Vocabulary vocabulary(Request request) {
    return factory().vocabulary(request);
  }
}
