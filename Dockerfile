# The study in a container: Debian 12 with what workflow/bootstrap installs, the built solver, a user without rights.
#   docker build -t dld-rbc .
#   docker run --rm -v "$PWD/results:/study/results" dld-rbc bash workflow/reproduce --config tier=smoke
FROM debian:12.12-slim

# As root, what only root can install: the system's packages that bootstrap names.
WORKDIR /study
COPY workflow/bootstrap workflow/
RUN bash workflow/bootstrap --system && rm -rf /var/lib/apt/lists/*

RUN useradd --create-home --uid 1000 study && chown study:study /study
USER study
COPY --chown=study:study workflow/requirements.txt workflow/requirements-build.txt workflow/
RUN bash workflow/bootstrap

COPY --chown=study:study . .
# For any processor of this family: the image runs elsewhere than where it was built.
RUN cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DDLD_NATIVE=OFF && cmake --build build --target dld
CMD ["bash", "workflow/reproduce", "--config", "tier=smoke"]
