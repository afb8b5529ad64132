package org.starl.platform;

import org.starl.geometry.Point;

/**
 * An object that a robot senses. Immutable.
 *
 * @param name of the object, by its tag; empty if the sensor cannot tell one object or wall from
 *     another
 * @param at the object's centre if it has a name, else a point of its surface
 * @param errorMm upper bound of the distance between {@code at} and the true point; 0 in the
 *     simulator
 */
public record Sighting(String name, Point at, double errorMm) {}
