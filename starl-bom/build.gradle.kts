plugins {
    `java-platform`
    id("maven-publish")
}

description = "Versions of StarL's modules, to import"

// The modules that the pom beside this file lists.
val listed = Regex("<artifactId>(.+)</artifactId>").findAll(file("pom.xml").readText())
    .map { it.groupValues[1] }
    .filter { it != name }
    .toList()

dependencies {
    constraints {
        listed.forEach { add("api", project(":$it")) }
    }
}
