package org.starl.apps;

/**
 * Something of an app's scenario that {@code --set key=value} may change.
 *
 * @param what one line, with the values that it takes
 */
public record Parameter(String key, String defaultValue, String what) {}
